"""Refuses subinterpreters, before cffi and NumPy are imported, which refuse them in words of their own."""


def is_main():
    """Whether this is the interpreter that the program began with."""
    for name in ("_interpreters", "_xxsubinterpreters"):  # of Python 3.13, and before
        try:
            module = __import__(name)
            own, main = module.get_current(), module.get_main()
        except (ImportError, AttributeError):
            continue
        return (own[0] if isinstance(own, tuple) else own) == (main[0] if isinstance(main, tuple) else main)
    return True


if not is_main():
    # Callbacks of cffi would take the lock of the main interpreter, and wait for it without an end.
    raise ImportError("whirl works in the main interpreter of a program alone, not in a subinterpreter")
