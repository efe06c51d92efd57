"""Read-only dictionaries: copies of the library's data."""

from . import errors


class ReadOnly(dict):
    """A dict that cannot be changed; the error names the function that changes the original. Copies are plain dicts."""

    def __init__(self, items, advice):
        super().__init__(items)
        self._advice = advice

    def _refuse(self, *_arguments, **_more):
        raise errors.ReadOnlyCopy(f"this dict is a copy, and changing it would change nothing: {self._advice}")

    __setitem__ = __delitem__ = __ior__ = _refuse
    update = setdefault = pop = popitem = clear = _refuse

    def __missing__(self, key):
        from difflib import get_close_matches

        near = get_close_matches(str(key), self, 1)
        words = f"did you mean {near[0]!r}?" if near else f"expected one of: {', '.join(self) or 'none'}"
        raise KeyError(f"there is no {key!r}, {words}")

    def __reduce__(self):
        return dict, (dict(self),)

    def __copy__(self):
        return dict(self)

    copy = __copy__

    def __deepcopy__(self, memo):
        from copy import deepcopy

        return deepcopy(dict(self), memo)
