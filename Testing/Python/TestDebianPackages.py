# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the Debian packages, unpacks them into an empty folder and uses what is there.

They are unpacked rather than installed, which needs no root and leaves the machine as it is. From
the folder a program is built, the Python package imported and a picture rendered; none of them may
find the build folder's library instead.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(os.environ["AIRLIGHT_BUILD_DIR"])
SOURCE = pathlib.Path(os.environ["AIRLIGHT_SOURCE_DIR"])
CMAKE = os.environ["AIRLIGHT_CMAKE"]
VERSION = os.environ["AIRLIGHT_VERSION"]
LIBRARY = "libvtkairlight" + VERSION.rsplit(".", 1)[0]
DEV, PYTHON, PROGRAM = "libvtkairlight-dev", "python3-airlight", "airlight"


def clean_environment(**changes):
    """The environment without what could lead to the build folder."""
    names = ("LD_LIBRARY_PATH", "PYTHONPATH", "CMAKE_PREFIX_PATH", "VTK_DIR", "Airlight_DIR")
    environment = {key: value for key, value in os.environ.items() if key not in names}
    return {**environment, **changes}


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, timeout=150, check=False,
                          env=clean_environment(**options.pop("environment", {})), **options)
    if done.returncode:
        raise AssertionError(f"{command}: {done.returncode}\n{done.stdout}")
    return done.stdout


def names(field):
    """The names of a field of dependencies: 'a (>= 1), b | c' gives a, b, c."""
    return set(re.findall(r"(?:^|[,|]) *([^ ,|]+)", field))


class TestDebianPackages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="airlight-packages-"))
        run(pathlib.Path(CMAKE).with_name("cpack"), "-G", "DEB",
            "--config", BUILD / "CPackConfig.cmake", "-B", cls.folder / "packages")
        cls.packages = {}
        for file in (cls.folder / "packages").glob("*.deb"):
            run("dpkg-deb", "-x", file, cls.folder / "root")
            text = re.sub(r"\n ", " ", run("dpkg-deb", "-f", file))
            fields = dict(line.split(": ", 1) for line in text.splitlines() if ": " in line)
            fields["file"] = file
            fields["listing"] = {line.split(None, 5)[5].split(" -> ")[0][2:]
                                 for line in run("dpkg-deb", "-c", file).splitlines()
                                 if not line.startswith("d")}
            cls.packages[fields["Package"]] = fields
        cls.prefix = cls.folder / "root" / "usr"

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def find(self, pattern):
        """The only file below the prefix of this pattern."""
        found = list(self.prefix.glob(pattern))
        self.assertEqual(len(found), 1, pattern)
        return found[0]

    def test_fields(self):
        self.assertEqual(set(self.packages), {LIBRARY, DEV, PYTHON, PROGRAM})
        architecture = run("dpkg", "--print-architecture").strip()
        for name, fields in self.packages.items():
            self.assertEqual(fields["Version"], VERSION + "-1")
            self.assertEqual(fields["Architecture"], architecture)
            self.assertEqual(fields["file"].name, f"{name}_{VERSION}-1_{architecture}.deb")
            self.assertIn(f"usr/share/doc/{name}/copyright", fields["listing"])
            if name != LIBRARY:
                self.assertIn(f"{LIBRARY} (= {VERSION}-1)", fields["Depends"])
        # The name says with which programs the library works: its SONAME's.
        soname = re.search(r"SONAME +(\S+)", run("objdump", "-p", self.library())).group(1)
        self.assertEqual(soname.lower().replace(".so.", ""), LIBRARY)
        self.assertRegex(self.packages[DEV]["Depends"], r"libvtk9-dev \(>= 9\.\d+\)")
        python = f"python3 (<< {sys.version_info[0]}.{sys.version_info[1] + 1})"
        self.assertIn(python, self.packages[PYTHON]["Depends"])
        self.assertIn("python3-vtk9", self.packages[PYTHON]["Depends"])

    def library(self):
        return self.find(f"lib/**/libvtkAirlight.so.{VERSION}")

    def test_shared_libraries(self):
        """Whatever a binary is linked to comes with a package that its package depends on."""
        linked = {}
        for package, file in ((LIBRARY, self.library()), (PROGRAM, self.prefix / "bin/airlight"),
                              (PYTHON, self.find("lib/**/airlight/vtkAirlight.*.so"))):
            paths = dict(re.findall(r"(\S+) => (/\S+)", run("ldd", file)))
            needed = re.findall(r"NEEDED +(\S+)", run("objdump", "-p", file))
            linked[package] = {os.path.realpath(paths[name]) for name in needed if name in paths}
        for package in (PROGRAM, PYTHON):
            self.assertIn(str(self.library()), linked[package])
            linked[package].remove(str(self.library()))
        # By the name alone: dpkg may know a file by a link to its folder.
        files = {os.path.basename(path) for paths in linked.values() for path in paths}
        owners = {}
        for line in run("dpkg", "-S", *("*/" + file for file in files)).splitlines():
            packages, file = line.split(": ")
            owners.setdefault(os.path.basename(file), set()).update(
                name.split(":")[0] for name in packages.split(", "))
        for package, paths in linked.items():
            self.assertGreaterEqual(len(paths), 3, package)
            depends = names(self.packages[package]["Depends"])
            for path in paths:
                file = os.path.basename(path)
                self.assertTrue(owners[file] & depends, f"{package}: {file} of {owners[file]}")

    def test_files(self):
        """Every file that is installed is in one package, in the one where it belongs."""
        listings = [fields["listing"] for fields in self.packages.values()]
        together = set().union(*listings)
        self.assertEqual(len(together), sum(map(len, listings)))
        run(CMAKE, "--install", BUILD, "--prefix", self.folder / "installed" / "usr")
        installed = {str(path.relative_to(self.folder / "installed"))
                     for path in (self.folder / "installed").rglob("*") if not path.is_dir()}
        self.assertEqual(together, installed)
        for name, pattern in ((LIBRARY, r"/lib[^/]*\.so\.[\d.]+$"), (PROGRAM, r"^usr/bin/"),
                              (DEV, r"\.(h|cmake|txt|json|data)$|/lib[^/]*\.so$"),
                              (PYTHON, r"/python3[^/]*/dist-packages/airlight/")):
            for path in self.packages[name]["listing"]:
                if not path.endswith("/copyright"):
                    self.assertRegex(path, pattern)

    def test_consumer(self):
        build = self.folder / "consumer"
        run(CMAKE, "-G", os.environ["AIRLIGHT_GENERATOR"], "-S", SOURCE / "Testing" / "Consumer",
            "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", "-DCMAKE_BUILD_TYPE=Release",
            f"-DVTK_DIR={os.environ['AIRLIGHT_VTK_DIR']}")
        cache = (build / "CMakeCache.txt").read_text()
        self.assertIn(f"Airlight_DIR:PATH={self.prefix}", cache)
        run(CMAKE, "--build", build, "--target", "consumer")
        program = build / "consumer"
        self.assertIn(str(self.library().parent), run("ldd", program))
        run(program)

    def test_python(self):
        folder = self.find("lib/**/dist-packages")
        script = ("import airlight, pathlib\n"
                  "medium = airlight.vtkParticipatingMedium()\n"
                  "medium.SetVisibility(3.912)\n"
                  "rgb = [0, 0, 0]\n"
                  "airlight.vtkAirlight.Transmittance(medium, (0, 0, 0), (0, 0, 2), rgb)\n"
                  "print(airlight.__version__, airlight.__file__, rgb[1])\n"
                  "airlight.vtkAirlightPass()\n"
                  "print(pathlib.Path('/proc/self/maps').read_text())\n")
        text = run(sys.executable, "-c", script, environment={"PYTHONPATH": str(folder)})
        version, file, transmittance = text.splitlines()[0].split()
        self.assertEqual(version, VERSION)
        self.assertEqual(file, str(folder / "airlight" / "__init__.py"))
        self.assertAlmostEqual(float(transmittance), 0.1353352832366127, delta=1e-12)  # exp(-2)
        loaded = set(re.findall(r"/\S*libvtkAirlight\.so\S*", text))
        self.assertEqual(loaded, {str(self.library())})

    def test_program(self):
        program = self.prefix / "bin" / "airlight"
        self.assertIn(VERSION, run(program, "--version"))
        picture = self.folder / "picture.pfm"
        run(program, "render", SOURCE / "Testing/Data/Reference/scenes/S1_point_iso.json",
            "--size", "32x24", "-o", picture)
        self.assertTrue(picture.read_bytes().startswith(b"PF\n32 24\n"))


if __name__ == "__main__":
    if not all(shutil.which(tool) for tool in ("dpkg-deb", "dpkg-shlibdeps", "objdump")):
        print("Skipped: Debian's packaging tools (dpkg-dev, binutils) are not here.")
        sys.exit(125)
    unittest.main(argv=[__file__])
