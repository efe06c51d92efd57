"""Forms of compiled functions: the arguments of slopes and tangents, and checks that a function takes them."""

import ctypes

import numpy as np

from . import errors
from ._library import ffi

#: arguments of functions by their form: slopes, slopes of many machines, tangents; each returns an int
FORMS = {
    "rates": "double t, const double *x, const double *p, double *dxdt, void *context",
    "lanes": "size_t count, size_t row, const double *t, const double *x, const double *p, double *dxdt, "
    "void *context",
    "tangent": "double t, const double *x, const double *p, const double *dx, double *ddxdt, void *context",
}
_NUMBERS = {"float64": "double", "float32": "float", "int32": "int", "uint64": "size_t"}
_CTYPES = {
    "double": ctypes.c_double,
    "double *": ctypes.POINTER(ctypes.c_double),
    "size_t": ctypes.c_size_t,
    "void *": ctypes.c_void_p,
}


def prototype_of(form, name):
    """Returns the declaration of a function of a form in C."""
    return f"int {name}({FORMS[form]})"


def callback_type(form):
    """Returns the type of a function for cffi."""
    return f"int({FORMS[form]})"


def words_of(form):
    """Returns the types of the arguments without const: "double", "double *", ..., "void *" """
    return [argument.replace("const ", "").rstrip("abcdefghijklmnopqrstuvwxyz").strip()
            for argument in FORMS[form].split(", ")]  # fmt: skip


def ctypes_prototype(form):
    """Returns the type of a function for ctypes."""
    return ctypes.CFUNCTYPE(ctypes.c_int, *(_CTYPES[word] for word in words_of(form)))


def _ctypes_word(kind):
    """Returns the name in C of a type of ctypes, or of an array argument of NumPy."""
    if kind is None:
        return "void"
    if kind is ctypes.c_void_p:
        return "void *"
    if isinstance(kind, type) and issubclass(kind, ctypes._Pointer):
        inner = _ctypes_word(kind._type_)
        return inner + ("*" if inner.endswith("*") else " *")
    try:
        dtype = np.dtype(getattr(kind, "_dtype_", None) or kind)
    except TypeError:
        return getattr(kind, "__name__", str(kind))
    number = dtype.name if dtype.isnative else "swapped_" + dtype.name
    word = _NUMBERS.get(number, number + "_t")
    return word + " *" if hasattr(kind, "_dtype_") else word


def _cffi_word(kind):
    """Returns the name in C of a type of cffi."""
    if kind.kind == "pointer":
        inner = _cffi_word(kind.item)
        return inner + ("*" if inner.endswith("*") else " *")
    if kind.kind != "primitive" or kind.cname in ("double", "float", "long double"):
        return kind.cname
    signed = "int" if int(ffi.cast(kind, -1)) < 0 else "uint"
    number = f"{signed}{8 * ffi.sizeof(kind)}"
    return _NUMBERS.get(number, number + "_t")


def _compare(what, form, result, arguments):
    """Rejects a function whose result or arguments differ from the form; the context may be any pointer."""
    expected = words_of(form)
    fits = len(arguments) == len(expected) and arguments[-1].endswith("*")
    if result != "int" or not fits or arguments[:-1] != expected[:-1]:
        raise errors.BadInput(
            f"{what} is a function '{result} ({', '.join(arguments)})', expected '{prototype_of(form, what)}'"
        )


def _unknown(what, form, why):
    words = {"rates": "", "lanes": "lanes=True", "tangent": "tangent=True"}[form]
    return errors.BadInput(
        f"{what} is {why}, so that nobody can check its form, expected '{prototype_of(form, what)}' as "
        f"whirl.systems.prototype({words}) declares it: prototype({words})(address)"
    )


def address_of(what, form, function):
    """Checks the form of a compiled function and returns its address; returns None for a function of Python.

    Raises BadInput for a function of another form, and for one whose form is unknown.
    """
    if isinstance(getattr(function, "form", None), str):  # the result of compile_c
        if function.form != form:
            raise errors.BadInput(
                f"{what} is a function '{prototype_of(function.form, what)}', expected '{prototype_of(form, what)}'"
            )
        return function.address
    own = getattr(function, "ctypes", None)
    compiled = own if isinstance(own, ctypes._CFuncPtr) else function  # a Numba cfunc
    if isinstance(compiled, ctypes._CFuncPtr):
        address = ctypes.cast(compiled, ctypes.c_void_p).value
        if not address:
            raise errors.BadInput(f"{what} is a pointer to nothing, expected a function")
        if compiled.argtypes is None:
            raise _unknown(what, form, "a function of ctypes without argtypes")
        _compare(what, form, _ctypes_word(compiled.restype), [_ctypes_word(each) for each in compiled.argtypes])
        return address
    if isinstance(function, ffi.CData):
        kind = ffi.typeof(function)
        kind = kind.item if kind.kind == "pointer" and kind.item.kind == "function" else kind
        if kind.kind != "function":
            raise _unknown(what, form, f"a '{kind.cname}' of cffi")
        address = int(ffi.cast("intptr_t", function))
        if not address:
            raise errors.BadInput(f"{what} is a pointer to nothing, expected a function")
        arguments = [_cffi_word(each) for each in kind.args] + (["..."] if kind.ellipsis else [])
        _compare(what, form, _cffi_word(kind.result), arguments)
        return address
    if isinstance(function, (int, np.integer)) and not isinstance(function, bool) and 0 < function < 1 << 64:
        raise _unknown(what, form, "an address")
    if isinstance(getattr(function, "address", None), int):
        raise _unknown(what, form, f"{type(function).__name__} with an address")
    if not callable(function):
        raise errors.BadInput(f"{what} is {function!r}, expected a function")
    return None
