// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the code that wraps classes for Python expects and VTK 9.5 lacks. The programs that write
 * this code are those of VTK 9.7, which include this header by its name: see vtk_sdk.py beside it.
 */

#ifndef vtkPythonTypeAccess_h
#define vtkPythonTypeAccess_h

#include "vtkPython.h"

// The modules are for one version of Python each, not for its stable ABI.
#define VTK_ABI3_LIMITED 0

// The methods behind a property such as `medium.visibility`.
struct PyVTKGetSet
{
  PyCFunction get;
  PyCFunction set;
  PyCFunction add;
};

namespace airlight_python
{
inline PyObject* Call(PyCFunction method, PyObject* self, PyObject* arguments)
{
  PyObject* result = arguments ? method(self, arguments) : nullptr;
  Py_XDECREF(arguments);
  return result;
}

inline int CallSetter(PyObject* self, PyObject* value, PyObject* arguments, void* methods)
{
  if (!value)
  {
    Py_XDECREF(arguments);
    PyErr_SetString(PyExc_AttributeError, "a property of a VTK object cannot be deleted");
    return -1;
  }
  PyObject* result = Call(static_cast<PyVTKGetSet*>(methods)->set, self, arguments);
  Py_XDECREF(result);
  return result ? 0 : -1;
}
}

inline PyObject* PyVTKObject_GetProperty(PyObject* self, void* methods)
{
  return airlight_python::Call(static_cast<PyVTKGetSet*>(methods)->get, self, PyTuple_New(0));
}

// The method takes the value.
inline int PyVTKObject_SetProperty(PyObject* self, PyObject* value, void* methods)
{
  return airlight_python::CallSetter(
    self, value, value ? PyTuple_Pack(1, value) : nullptr, methods);
}

// The method takes the numbers of the value as arguments, or the value.
inline int PyVTKObject_SetPropertyMulti(PyObject* self, PyObject* value, void* methods)
{
  const bool numbers = value && PySequence_Check(value) && !PyUnicode_Check(value);
  return numbers ? airlight_python::CallSetter(self, value, PySequence_Tuple(value), methods)
                 : PyVTKObject_SetProperty(self, value, methods);
}

// The methods remove all that was added, then add each item of the value.
inline int PyVTKObject_SetPropertySequence(PyObject* self, PyObject* value, void* methods)
{
  PyObject* items = value ? PySequence_Fast(value, "a sequence is expected") : nullptr;
  if (value && !items)
  {
    return -1;
  }
  int result = airlight_python::CallSetter(self, value, PyTuple_New(0), methods);
  auto* adding = static_cast<PyVTKGetSet*>(methods);
  for (Py_ssize_t i = 0; result == 0 && i < PySequence_Fast_GET_SIZE(items); ++i)
  {
    PyObject* item = PyTuple_Pack(1, PySequence_Fast_GET_ITEM(items, i));
    PyObject* added = airlight_python::Call(adding->add, self, item);
    Py_XDECREF(added);
    result = added ? 0 : -1;
  }
  Py_XDECREF(items);
  return result;
}

#endif
