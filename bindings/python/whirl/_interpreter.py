"""Refuses subinterpreters, before cffi and NumPy are imported, which refuse them in words of their own."""


def is_main():
    """Returns whether this is the program's main interpreter."""
    for name in ("_interpreters", "_xxsubinterpreters"):  # names in Python 3.13, and before
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
