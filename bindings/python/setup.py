"""Puts libwhirl into the package: built by CMake from the surrounding sources, or taken from the path WHIRL_BUILT."""

import os
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py
from setuptools.dist import Distribution

try:  # part of setuptools since 70.1, and no longer of the latest versions of the package wheel
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:
    try:
        from wheel.bdist_wheel import bdist_wheel
    except ImportError:
        raise SystemExit(
            f"{sys.executable} has setuptools before 70.1 and no package 'wheel': install either, leave out"
            " --no-build-isolation so that pip fetches it, or call Debian's own: /usr/bin/python3 -m pip"
        ) from None

SONAME = "libwhirl.so.1"
HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]


def built_library():
    """Returns the path of the built library."""
    given = os.environ.get("WHIRL_BUILT")
    if given:
        return Path(given)
    if not (ROOT / "CMakeLists.txt").exists():
        raise SystemExit(
            f"{ROOT} has no CMakeLists.txt: build in bindings/python of whirl's sources, or set WHIRL_BUILT"
        )
    build = ROOT / "build" / "python"
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DWHIRL_TESTS=OFF", "-DWHIRL_MPI=OFF"]
    subprocess.run(["cmake", "-S", ROOT, "-B", build, *options], check=True)
    subprocess.run(
        ["cmake", "--build", build, "--parallel", str(os.cpu_count() or 1), "--target", "whirl_shared"], check=True
    )
    return build / SONAME


class BuildWithLibrary(build_py):
    """Copies the package's modules, and makes declarations, library and explorer template next to them."""

    def run(self):
        super().run()
        package = Path(self.build_lib) / "whirl"
        subprocess.run([sys.executable, HERE / "whirl" / "_declare.py", package / "_declarations.py"], check=True)
        native = package / "_native"
        native.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(built_library(), native / SONAME)
        if shutil.which("strip"):
            subprocess.run(["strip", "--strip-unneeded", native / SONAME], check=True)
        template = os.environ.get("WHIRL_EXPLORER", ROOT / "build" / "explorer" / "template.html")
        if Path(template).exists():
            shutil.copyfile(template, native / "explorer.html")


class PlatformWheel(bdist_wheel):
    """One wheel for every Python 3 of a platform: the library is C, and called without compiled Python code."""

    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False

    def get_tag(self):
        return "py3", "none", sysconfig.get_platform().replace("-", "_").replace(".", "_")


class WithLibrary(Distribution):
    def has_ext_modules(self):
        return True


setup(cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel}, distclass=WithLibrary)
