"""Refuses subinterpreters before cffi and NumPy are imported, whose messages about them are less clear."""


def is_main():
    """Returns True in the program's main interpreter."""
    for name in ("_interpreters", "_xxsubinterpreters"):  # names in Python 3.13, and before
        try:
            module = __import__(name)
            own, main = module.get_current(), module.get_main()
        except (ImportError, AttributeError):
            continue
        return (own[0] if isinstance(own, tuple) else own) == (main[0] if isinstance(main, tuple) else main)
    return True


if not is_main():
    # In a subinterpreter, callbacks of cffi would wait for the lock of the main interpreter for ever.
    raise ImportError("whirl works in the main interpreter of a program alone, not in a subinterpreter")
