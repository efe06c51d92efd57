"""Identifies functions by a checksum of their code and of all objects that they use.

Two functions with the same checksum compute the same from the same arguments, as long as they read no files. For an
object whose content cannot be known (an address, an open file, a lock), :class:`Unknown` is raised with its name.
"""

import builtins
import copyreg
import ctypes
import dis
import functools
import hashlib
import importlib
import pickle
import platform
import sys
import sysconfig
import types
from importlib import machinery, metadata
from operator import attrgetter
from pathlib import Path

_PYTHON = [Path(sysconfig.get_path(name)).resolve() for name in ("stdlib", "platstdlib")]
_PACKAGES = {"site-packages", "dist-packages"}
_PLAIN = {type(None), bool, int, float, complex, type(Ellipsis), type(NotImplemented), str, bytes}
_UNSEEN = {"eval", "exec", "compile", "globals", "__import__", "open", "input"}
_OF_CLASSES = {"__dict__", "__weakref__", "__module__", "__doc__", "__firstlineno__", "__static_attributes__"}
_CACHES = {"_abc_impl", "__abstractmethods__"}
_DESCRIPTORS = (types.MemberDescriptorType, types.GetSetDescriptorType, types.WrapperDescriptorType)


class Unknown(Exception):
    """Raised for something without a checksum; its text names the thing."""


def checksum(*objects) -> str:
    """Returns the checksum of functions and other objects, in their order."""
    digest = _Digest()
    try:
        for one in objects:
            digest.add(one)
    except RecursionError:
        raise Unknown("it closes over more than can be followed") from None
    return digest.sum.hexdigest()


def _version(package):
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return getattr(sys.modules.get(package), "__version__", None)


@functools.lru_cache(maxsize=None)
def _of_file(path):
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def _edition(module):
    """Returns a text that, with a module's name, identifies its whole content; None for a user's own module."""
    file, package = getattr(module, "__file__", None), module.__name__.partition(".")[0]
    if module.__name__ in sys.builtin_module_names and file is None:
        return platform.python_version()
    place = Path(file).resolve() if file else None
    if place and _PACKAGES.intersection(place.parts):
        version = _version(package)
        return version and f"{package} {version}"
    if place and any(place.is_relative_to(folder) for folder in _PYTHON):
        return platform.python_version()
    return _of_file(place) if place and place.name.endswith(tuple(machinery.EXTENSION_SUFFIXES)) else None


def _is_of(module, thing, name):
    """Returns True if a module has this object under the object's name."""
    try:
        return attrgetter(name)(module) is thing
    except AttributeError:
        return False


def _codes(code):
    """Yields a code object and the code objects nested in it."""
    yield code
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from _codes(constant)


class _Digest:
    def __init__(self):
        self.sum, self.seen = hashlib.sha256(), {}

    def put(self, kind, data=b""):
        data = data.encode("utf-8", "surrogatepass") if isinstance(data, str) else data
        self.sum.update(f"{kind} {len(data)} ".encode() + data)

    def add(self, thing):
        """Adds any object once; an object that appears again is added by its number, so that cycles end."""
        kind = type(thing)
        if kind in _PLAIN:
            return self.put(kind.__name__, thing if kind in (str, bytes) else repr(thing))
        if kind in (tuple, frozenset):  # compilers may merge equal constants or not
            return self.add_new(thing)
        if id(thing) in self.seen:
            return self.put("again", str(self.seen[id(thing)][0]))
        self.seen[id(thing)] = len(self.seen), thing  # a reference, so that no other object gets its id
        self.add_new(thing)

    def add_all(self, kind, parts):
        self.put(kind, str(len(parts)))
        for part in parts:
            self.add(part)

    def add_new(self, thing):
        kind = type(thing)
        if kind in (tuple, list):
            self.add_all(kind.__name__, thing)
        elif kind in (dict, types.MappingProxyType):
            self.add_all("dict", [part for item in thing.items() for part in item])
        elif kind in (set, frozenset):
            self.put("set", " ".join(sorted(checksum(one) for one in thing)))
        elif isinstance(thing, types.ModuleType):
            self.add_module(thing, ())
        elif kind is types.CodeType:
            self.add_code(thing)
        elif isinstance(thing, (types.FunctionType, type)) and self.add_named(thing, thing.__module__):
            pass
        elif kind is types.FunctionType:
            self.add_function(thing)
        elif isinstance(thing, type):
            self.add_class(thing)
        else:
            self.add_object(thing)

    def add_named(self, thing, module, name=None):
        """Adds an object by its name if its module has an edition (_edition); else returns False."""
        module, name = sys.modules.get(module or ""), name or thing.__qualname__
        edition = module is not None and _is_of(module, thing, name) and _edition(module)
        if edition:
            self.put("named", f"{module.__name__} {name} {edition}")
        return bool(edition)

    def add_module(self, module, attributes):
        """Adds a module; of a user's own module the attributes that may be used."""
        edition = _edition(module)
        self.put("module", f"{module.__name__} {edition or ''}")
        if edition:
            return
        if not attributes:
            raise Unknown(f"it keeps the module {module.__name__}, of which it may take anything")
        for name in sorted(attributes & set(vars(module))):
            self.put("attribute", name)
            self.add_taken(getattr(module, name), attributes - {name})

    def add_taken(self, thing, attributes):
        self.add_module(thing, attributes | {""}) if isinstance(thing, types.ModuleType) else self.add(thing)

    def add_code(self, code):
        self.put("code", code.co_code + getattr(code, "co_exceptiontable", b""))
        shape = code.co_argcount, code.co_posonlyargcount, code.co_kwonlyargcount, code.co_flags
        self.add((*shape, code.co_names, code.co_varnames, code.co_freevars, code.co_cellvars, code.co_consts))

    def add_function(self, function):
        """Adds the code of a function, and the objects whose names it loads: from its cells, its module and imported
        modules."""
        code, scope, loads, imports = function.__code__, function.__globals__, set(), set()
        taken = {name for one in _codes(code) for name in one.co_names}
        for one in (each for inner in _codes(code) for each in dis.get_instructions(inner)):
            if one.opname in ("LOAD_GLOBAL", "LOAD_NAME"):
                loads.add(one.argval)
            elif one.opname == "IMPORT_NAME":
                imports.add(one.argval)
        self.put("function", platform.python_version())
        for part in (code, function.__defaults__, function.__kwdefaults__, function.__dict__):
            self.add(part)
        for name, cell in zip(code.co_freevars, function.__closure__ or ()):
            self.put("cell", name)
            if cell != types.CellType():
                self.add_taken(cell.cell_contents, taken)
        for name in sorted(loads):
            if name not in scope and name in _UNSEEN:
                raise Unknown(f"it calls {name}(), which may take anything")
            self.put("global", name)
            self.add_taken(scope.get(name, getattr(builtins, name, None)), taken)
        for name in sorted(imports):
            try:
                self.add_taken(importlib.import_module(name), taken)
            except ImportError:
                raise Unknown(f"it imports {name}, which is not found") from None

    def add_class(self, cls):
        self.put("class", cls.__qualname__)
        self.add((type(cls), cls.__bases__))
        for name, value in sorted(vars(cls).items()):
            if name not in _OF_CLASSES and name not in _CACHES:
                self.put("attribute", name)
                self.add(value)

    def add_object(self, thing):
        if isinstance(thing, types.MethodType):
            self.add_all("method", [thing.__func__, thing.__self__])
        elif isinstance(thing, property):
            self.add_all("property", [thing.fget, thing.fset, thing.fdel])
        elif isinstance(thing, functools.partial):
            self.add_all("partial", [thing.func, thing.args, thing.keywords])
        elif isinstance(thing, _DESCRIPTORS):
            self.put("descriptor", thing.__name__)
        elif hasattr(thing, "py_func"):  # a Numba function that is compiled at its first call
            self.add_all("jit", [type(thing), thing.py_func, repr(getattr(thing, "targetoptions", ""))])
        elif hasattr(thing, "__wrapped__"):  # a Numba cfunc, a caching wrapper, or a method of a class
            self.add_all("wrapped", [type(thing), thing.__wrapped__, repr(getattr(thing, "_sig", ""))])
        elif hasattr(thing, "__func__"):
            self.add_all("of a class", [type(thing), thing.__func__])
        else:
            self.add_reduced(thing)

    def add_reduced(self, thing):
        """Adds any other object by its pickle reduction."""
        if isinstance(thing, ctypes.CDLL):
            raise Unknown(f"it calls the library {thing._name}, whose code is not known")
        try:
            reduce = copyreg.dispatch_table.get(type(thing))
            parts = reduce(thing) if reduce else thing.__reduce_ex__(4)
        except Exception:
            raise Unknown(f"it uses {thing!r:.80}, a {type(thing).__name__}, whose content is not known") from None
        if isinstance(parts, str):
            of_type = type(thing).__module__.partition(".")[0]  # NumPy's functions do not name their module
            if not any(self.add_named(thing, module, parts) for module in (of_type, pickle.whichmodule(thing, parts))):
                raise Unknown(f"it uses {parts}, whose code is not known")
            return
        function, arguments, state, items, pairs = (*parts, None, None, None)[:5]
        self.add_all("object", [type(thing), function, arguments, state])
        for one in (items, pairs):
            self.add(None if one is None else list(one))
