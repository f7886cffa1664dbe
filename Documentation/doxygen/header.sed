# What Doxygen reads of a header: the public interface, with a line for what all classes of VTK have.
s|^  static vtk[A-Za-z0-9]*\* New();|  /** Makes an object with the defaults below. */\n&|
s|^  void PrintSelf(.*|  /** Writes the properties and their values. */\n&|
# Members for derived classes and private ones are between here and the end of the class.
/^protected:/,/^};/{
/^};/!d
}
