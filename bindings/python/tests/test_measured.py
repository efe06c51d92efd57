"""MAT files of SciPy and Octave, and universal files, are read by the library: for columns, fits, figures and
records."""

import shutil
import struct
import subprocess

import h5py
import numpy as np
import pytest
from conftest import COMMAND
from test_fit import SPRING, TRUTH, check_waveform, waveform

import whirl

TYPES = ["f8", "f4", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "?"]


def variables():
    """Returns numbers of all classes in rows, columns, matrices and structures."""
    rng = np.random.default_rng(5)
    found = {}
    for index, kind in enumerate(TYPES):
        numbers = rng.integers(0, 100, 12).astype(kind)
        found[f"row_{index}"], found[f"column_{index}"] = numbers, numbers[::-1].reshape(-1, 1)
    found["real"], found["large"] = rng.standard_normal(12), 2.0 ** np.arange(12) * 1e200
    return {**found, "run": {"inner": dict(found), "matrix": rng.standard_normal((4, 12))}}


def check_variables(path, given, prefix=""):
    """Compares all vectors of a file with the numbers that were written, exactly."""
    read = whirl.read_measured(path)
    for name, numbers in given.items():
        if isinstance(numbers, dict):
            check_variables(path, numbers, f"{prefix}{name}/")
        elif max(numbers.shape) == numbers.size:
            assert list(read[prefix + name]) == [float(number) for number in numbers.ravel()]
        else:
            for index, row in enumerate(numbers):  # MATLAB's rows are the last index, as in version 7.3
                for path_of in (f"{prefix}{name}", f"{prefix}{name}".replace("/", ".")):
                    part = whirl.read_measured(path, {"a": f"{path_of}[:, {index}]"})["a"]
                    assert list(part) == list(row)


@pytest.mark.parametrize("compressed", [False, True])
def test_files_of_scipy(tmp_path, compressed):
    io = pytest.importorskip("scipy.io")
    given = variables()
    io.savemat(tmp_path / "a.mat", given, do_compression=compressed)
    check_variables(tmp_path / "a.mat", given)
    # Level 4 has neither structures nor most classes.
    flat = {name: np.atleast_2d(v) for name, v in given.items() if name in ("real", "large", "row_0", "column_0")}
    flat["matrix"] = given["run"]["matrix"]
    io.savemat(tmp_path / "b.mat", flat, format="4")
    check_variables(tmp_path / "b.mat", flat)


def test_the_same_parts_as_in_version_7_3(tmp_path):
    io = pytest.importorskip("scipy.io")
    matrix = np.arange(24.0).reshape(4, 6)
    io.savemat(tmp_path / "a.mat", {"m": matrix})
    with h5py.File(tmp_path / "b.mat", "w", userblock_size=512) as file:
        file["m"] = matrix.T  # as MATLAB writes it
    for part in ("m[:, 0]", "m[:, -1]", "m[2, :]", "m[ 5 , : ]"):
        one, other = (whirl.read_measured(tmp_path / name, {"a": part})["a"] for name in ("a.mat", "b.mat"))
        assert list(one) == list(other)
    assert list(whirl.read_measured(tmp_path / "a.mat", {"a": "m[:, 1]"})["a"]) == list(matrix[1])
    # Texts, which give units, are whole numbers with an attribute in version 7.3.
    io.savemat(tmp_path / "a.mat", {"x": matrix[0], "x_unit": "mm", "note": "fan 3"})
    with h5py.File(tmp_path / "b.mat", "w", userblock_size=512) as file:
        file["x"] = matrix[:1].T
        for name, words in (("x_unit", "mm"), ("note", "fan 3")):
            file[name] = np.frombuffer(words.encode("utf-16-le"), "u2").reshape(-1, 1)
            file[name].attrs["MATLAB_class"] = np.bytes_("char")
    one, other = (whirl.read_measured(tmp_path / name) for name in ("a.mat", "b.mat"))
    assert list(one) == list(other) == ["x [mm]"] and list(one["x [mm]"]) == list(other["x [mm]"]) == list(matrix[0])


@pytest.mark.skipif(not shutil.which("octave"), reason="needs Octave")
def test_files_of_octave(tmp_path):
    matrix, row = np.arange(1.0, 13.0).reshape(3, 4) / 7, np.array([3, -4, 7])
    code = "m = reshape(1:12, 4, 3)' / 7; k = int16([3 -4 7]); on = [true false true]; q = single([1 2 4]) / 3; "
    code += "run.x = m; run.more.k = k; x_unit = 'um'; x = [0.1 0.2 0.3]; "
    for name in ("v4", "v6", "v7"):
        kept = "m x x_unit" if name == "v4" else "m k on q run x x_unit"
        code += f"save -{name} {name}.mat {kept}; "
    subprocess.run(["octave", "--norc", "--no-gui", "--eval", code], cwd=tmp_path, check=True, capture_output=True)
    for name in ("v4", "v6", "v7"):
        path = tmp_path / f"{name}.mat"
        for index in range(3):
            for variable in ("m",) if name == "v4" else ("m", "run/x"):
                assert list(whirl.read_measured(path, {"a": f"{variable}[:, {index}]"})["a"]) == list(matrix[index])
        assert list(whirl.read_measured(path, {"a": "x"})["a [um]"]) == [0.1, 0.2, 0.3]
        if name != "v4":
            read = whirl.read_measured(path)
            assert list(read["k"]) == list(read["run/more/k"]) == list(row)
            assert list(read["on"]) == [1, 0, 1]
            assert list(read["q"]) == list((np.array([1, 2, 4], "f4") / np.float32(3)).astype(float))


def test_fits_and_figures_of_matlab_files(tmp_path):
    io = pytest.importorskip("scipy.io")
    time, x, y = waveform()
    data = {"time": time, "time_unit": "s", "disc_x": x, "disc_x_unit": "um", "disc_y": 1e-3 * y, "disc_y_units": "mm"}
    io.savemat(tmp_path / "a.mat", data, do_compression=True)
    check_waveform(tmp_path / "a.mat")
    io.savemat(tmp_path / "b.mat", {"run": {"signals": np.column_stack([x, y, time]), "note": "fan 3"}})
    names = {"time [s]": "run.signals[2, :]", "disc x [um]": "run/signals[0, :]", "disc y [um]": "run/signals[1, :]"}
    check_waveform({"file": tmp_path / "b.mat", "columns": names})
    with pytest.raises(whirl.BadInput, match="b.mat has no variable 'run/signal', did you mean 'run/signals'"):
        check_waveform({"file": tmp_path / "b.mat", "columns": {**names, "disc x [um]": "run/signal"}})
    # A coast-down from 1800 rpm as MATLAB's variables and as a table has the same figures.
    t = np.arange(6001) / 2000
    angle = 2 * np.pi * (30 * t - 4 * t * t)
    columns = {"time": t, "keyphasor": np.sin(angle), "de_x": 20 * np.cos(angle), "de_y": 20 * np.sin(angle)}
    units = {"time_unit": "s", "de_x_unit": "um", "de_y_unit": "um"}
    io.savemat(tmp_path / "down.mat", {**columns, **units})
    with open(tmp_path / "down.csv", "w") as file:
        file.write("time [s],keyphasor [V],de x [um],de y [um]\n")
        np.savetxt(file, np.column_stack(list(columns.values())), "%.17g", ",")
    drawn = []
    for name in ("down.mat", "down.csv"):
        command = [COMMAND, "figure", name, "runup-de", "-o", "-"]
        drawn.append(subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True).stdout)
    assert len(drawn[0]) > 1000 and drawn[0].replace("down.mat", "down.csv") == drawn[1]
    one, other = (whirl.signals.load(tmp_path / name) for name in ("down.mat", "down.csv"))
    assert one.statements() == other.statements()
    # Columns with names of their own are chosen, also from a matrix.
    odd = {"t": columns["time"], "key": columns["keyphasor"], "X": np.column_stack([columns["de_x"], columns["de_y"]])}
    io.savemat(tmp_path / "odd.mat", odd)
    names = {"time [s]": "t", "keyphasor": "key", "de x [um]": "X[0, :]", "de y [um]": "X[1, :]"}
    assert whirl.signals.load(tmp_path / "odd.mat", names).statements() == other.statements()
    with pytest.raises(whirl.BadInput, match="no variable 'key2'"):
        whirl.signals.load(tmp_path / "odd.mat", {**names, "keyphasor": "key2"})
    read = whirl.read_measured(tmp_path / "down.csv", {"x [um]": "de x", "key": "column 2"})
    assert list(read) == ["x [um]", "key [V]"] and list(read["x [um]"]) == list(columns["de_x"])


def universal(kind, heading, values, *, axis=(17, "s"), start=0.0, step=1.0, unit="um", first="NONE"):
    """Returns a dataset 58 as text, or 58b as bytes, of the format's specification; kind is 2, 4, 5 or 6, and "b" for
    bytes."""
    number, (name, direction) = int(kind[0]), heading
    lines = [
        first,
        *("NONE",) * 4,
        f"{1:5d}{0:10d}{0:5d}{0:10d} {name:10s}{1:10d}{direction:4d} {'NONE':10s}{0:10d}{0:4d}",
        f"{number:10d}{len(values):10d}{1:10d}{start:13.5E}{step:13.5E}{0:13.5E}",
        f"{axis[0]:10d}{0:5d}{0:5d}{0:5d} {'NONE':20s} {axis[1]:20s}",
        f"{8:10d}{0:5d}{0:5d}{0:5d} {'Displacement':20s} {unit:20s}",
        *(f"{0:10d}{0:5d}{0:5d}{0:5d} {'NONE':20s} {'NONE':20s}",) * 2,
    ]
    head = "\n".join(lines) + "\n"
    numbers = np.column_stack([np.real(values), np.imag(values)]).ravel() if number > 4 else np.asarray(values)
    if kind[1:]:
        data = numbers.astype(">f8" if number in (4, 6) else ">f4").tobytes()
        title = f"    58b{2:6d}{2:6d}{11:12d}{len(data):12d}{0:6d}{0:6d}{0:12d}{0:12d}"
        return f"    -1\n{title}\n{head}".encode() + data + b"\n    -1\n"
    form, columns = ("{:20.12E}", 4) if number in (4, 6) else ("{:13.5E}", 6)
    rows = ["".join(form.format(v) for v in numbers[i : i + columns]) for i in range(0, len(numbers), columns)]
    return f"    -1\n    58\n{head}{chr(10).join(rows)}\n    -1\n".encode()


@pytest.mark.parametrize("kind", ["6", "6b"])
def test_bode_plots_of_universal_files(tmp_path, kind):
    """Tests a complex response over the speed: amplitude and lag are columns of a fit."""
    rpm = np.arange(600.0, 1500.0, 100.0)
    w = rpm * 2 * np.pi / 60
    z = 1e6 * TRUTH["e"] * w**2 / (TRUTH["k"] / 3 - w**2 + 1j * TRUTH["c"] * w / 3)
    path = tmp_path / "bode.uff"
    path.write_bytes(universal(kind, ("disc", 1), z, axis=(19, "NONE"), start=600, step=100))
    found = whirl.fit(SPRING, path, ["k", "c", "e"], tolerance=1e-10)
    for name, value in TRUTH.items():
        assert found[name].value == pytest.approx(value, rel=1e-9)
    read = whirl.read_measured(path, {"re": "disc x/real", "im": "record 1/imaginary", "speed": "record 1/speed"})
    assert list(read["speed [rpm]"]) == list(rpm)
    assert read["re [um]"] + 1j * read["im [um]"] == pytest.approx(z, rel=1e-12 if kind == "6" else 0, abs=0)
    # The command reads the same.
    text = whirl.Case(SPRING).text.split("study:")[0]
    text += "study:\n  fit: {unknown: {k: , c: , e: }, data: bode.uff, tolerance: 1e-10}\n"
    (tmp_path / "a.yaml").write_text(text)
    done = subprocess.run([COMMAND, "run", "a.yaml"], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "33" in done.stdout


def test_records_of_universal_files(tmp_path):
    path = tmp_path / "down.unv"
    t = np.arange(6001) / 2000
    angle = 2 * np.pi * (30 * t - 4 * t * t)
    x, y = 20 * np.cos(angle), -20 * np.sin(angle)
    with open(path, "wb") as file:
        for heading, values, unit in ((("key", 0), np.sin(angle), "V"), (("de", 1), x, "UM"), (("de", -2), y, "um")):
            file.write(universal("4b", heading, values, step=1 / 2000, unit=unit, first="Coast-down"))
    read = whirl.read_measured(path)
    assert list(read) == ["time [s]", "key [V]", "de x [um]", "de 270 [um]"]
    assert list(read["time [s]"]) == list(0.0 + 0.0005 * np.arange(6001)) and list(read["de 270 [um]"]) == list(y)
    by_number = whirl.read_measured(path, {"keyphasor [V]": 1, "de x [um]": 2})
    assert list(by_number) == ["time [s]", "keyphasor [V]", "de x [um]"] and list(by_number["de x [um]"]) == list(x)
    path.write_bytes(path.read_bytes().replace(b"key       ", b"keyphasor "))
    with open(tmp_path / "down.csv", "w") as file:
        file.write("time [s],keyphasor [V],de x [um],de 270 [um]\n")
        np.savetxt(file, np.column_stack([read["time [s]"], np.sin(angle), x, y]), "%.17g", ",")
    one, other = (whirl.signals.load(tmp_path / name) for name in ("down.unv", "down.csv"))
    assert one.statements() == other.statements()


def test_what_cannot_be_read_is_refused(tmp_path):
    def refused(words, content, columns=None):
        (tmp_path / "a.mat").write_bytes(content)
        with pytest.raises(whirl.BadInput, match=words):
            whirl.read_measured(tmp_path / "a.mat", columns)

    io = pytest.importorskip("scipy.io")
    io.savemat(tmp_path / "b.mat", {"x": np.arange(9.0), "z": np.arange(9) * 1j, "pair": np.ones((9, 2))})
    good = (tmp_path / "b.mat").read_bytes()
    refused("a.mat: z has complex numbers, expected numbers", good, {"a": "z"})
    refused("pair has 2 x 9 numbers, expected a vector, or indices one of which is ':'", good, {"a": "pair"})
    refused("a.mat has no variable 'pairs', did you mean 'pair'", good, {"a": "pairs"})
    refused("a.mat: is damaged or cut off", good[:-3])
    refused("a.mat: is no HDF5, MAT or universal file", b"no file of MATLAB", {"a": "x"})
    io.savemat(tmp_path / "b.mat", {"x": np.arange(999.0)}, do_compression=True)
    packed = bytearray((tmp_path / "b.mat").read_bytes())
    packed[-20] ^= 1
    refused("a.mat: is damaged: what it has compressed cannot be read", bytes(packed))
    one = universal("4", ("disc", 1), np.arange(9.0))
    refused("dataset 58 number 1, line 1[0-9]: is cut off", one[:-10])
    refused("line 9: its type, count and spacing", one.replace(b"         4         9", b"         4      nine"))
    refused("expected 2, 4, 5 or 6", one.replace(b"         4         9", b"         7         9"))
    refused(
        "has 72 bytes, expected 36",
        universal("4b", ("disc", 1), np.arange(9.0)).replace(b"\n         4", b"\n         2"),
    )
    refused("has fewer numbers than it says", one.replace(b"         4         9", b"         4        10"))


def test_the_order_of_bytes_is_that_of_the_file(tmp_path):
    """Tests a file of a machine whose numbers begin with the largest place, as SciPy reads it."""
    io = pytest.importorskip("scipy.io")
    name, numbers = b"wave", np.array([1.5, -2.25, 1e-300, 7.0])
    matrix = struct.pack(">IIII", 6, 8, 6, 0) + struct.pack(">IIII", 5, 8, 1, 4)
    matrix += struct.pack(">I", 4 << 16 | 1) + name + struct.pack(">II", 9, 32) + numbers.astype(">f8").tobytes()
    head = b"MATLAB 5.0 MAT-file".ljust(124) + struct.pack(">H", 0x0100) + b"MI"
    (tmp_path / "a.mat").write_bytes(head + struct.pack(">II", 14, len(matrix)) + matrix)
    assert list(whirl.read_measured(tmp_path / "a.mat")["wave"]) == list(numbers)
    assert list(io.loadmat(tmp_path / "a.mat")["wave"].ravel()) == list(numbers)
