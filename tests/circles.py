"""No two files of a layer need each other, directly or by way of others:  circles.py BUILD LAYER...

Who needs whom is read from the objects: a file needs another one where it uses a symbol that the other defines. The kernels of
all instruction sets count as one file.
"""
import pathlib
import re
import subprocess
import sys


def symbols_of(folder):
    """Symbols that files define, {symbol: file}, and use, {file: {symbol}}."""
    defined, used = {}, {}
    objects = sorted(folder.rglob("*.o"))
    listing = subprocess.check_output(["nm", "-A", *objects], text=True) if objects else ""
    for line in listing.splitlines():
        path, _, entry = line.partition(":")
        name = re.sub(r"_(scalar|128|fma|avx2|avx512)$", "", re.sub(r"\.cc?\.o$", "", pathlib.Path(path).name))
        *_, kind, symbol = entry.split()
        if kind == "U":
            used.setdefault(name, set()).add(symbol)
        elif kind in "TDBRV":
            defined[symbol] = name
    return defined, used


def circle_through(start, needs):
    """The files of a shortest way from `start` back to itself, or None."""
    ways, seen = [[start]], set()
    while ways:
        way = ways.pop(0)
        for other in sorted(needs.get(way[-1], ())):
            if other == start:
                return way
            if other not in seen:
                seen.add(other)
                ways.append(way + [other])
    return None


def main(build, *layers):
    found = 0
    for layer in layers:
        folder = pathlib.Path(build) / f"CMakeFiles/whirl_{layer}.dir/src/{layer}"
        defined, used = symbols_of(folder)
        if not defined:
            sys.exit(f"circles: no objects in {folder}")
        needs = {name: {defined[s] for s in symbols if s in defined} - {name} for name, symbols in used.items()}
        told = set()
        for name in sorted(needs):
            way = circle_through(name, needs)
            if way and not told & set(way):
                told |= set(way)
                found += 1
                print(f"FAILED: src/{layer}: a circle of files: {' -> '.join(way + [name])}")
    if found == 0:
        print(f"{len(layers)} layers without a circle")
    return found > 0


sys.exit(main(*sys.argv[1:]))
