"""Tests runs: progress, journals, and Ctrl-C."""

import copy
import os
import pickle
import subprocess
import sys
import warnings
import weakref

import numpy as np
import pytest
from conftest import GOOD

import whirl


def test_progress_is_told():
    seen = []
    whirl.run(whirl.Case(GOOD), progress=lambda *about: seen.append(about))
    stage, done, total, revolutions, all_revolutions = seen[-1]
    assert stage == "compute" and done == total == 5 and revolutions == all_revolutions > 0


def test_threads_change_no_bit(good):
    one = whirl.run(whirl.Case(GOOD), threads=1, progress=False)
    for field in good["sweep"]:
        assert one["sweep"][field].tobytes() == good["sweep"][field].tobytes(), field


def test_threads_are_a_number():
    for threads in (-1, 2000, 2**31, 10**12):
        with pytest.raises(whirl.BadInput, match=f"threads is {threads}, expected 0"):
            whirl.run(whirl.Case(GOOD), threads=threads, progress=False)


def test_what_progress_raises_ends_the_run():
    def report(*about):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        whirl.run(whirl.Case(GOOD), progress=report)


def stopped_run(tmp_path, *more):
    """Runs a program that gets Ctrl-C once some points are done; returns how it ended."""
    program = f"""
import os, signal, sys, warnings, whirl
case = whirl.Case({str(GOOD)!r}).set("integrate.transient", 20000).set("sweep.points", 400)
def report(stage, done, *more):
    if done > 20: os.kill(os.getpid(), signal.SIGINT)
with warnings.catch_warnings(record=True) as warned:
    warnings.simplefilter("always")
    result = whirl.run(case, threads=2, progress=report, {', '.join(more)})
print(result.partial, len(result["sweep"].values), warned[0].message if warned else "")
result.save("part.h5")
"""
    return subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, timeout=120)


def test_ctrl_c_gives_what_is_done(tmp_path):
    ended = stopped_run(tmp_path)
    assert ended.returncode == 0, ended.stderr
    partial, count, said = ended.stdout.split(maxsplit=2)
    assert partial == "True" and 20 <= int(count) < 400
    assert said.startswith("stopped after") and "the result is partial" in said
    part = whirl.open(tmp_path / "part.h5")
    assert part.partial and len(part["sweep"].values) == int(count)


def test_a_journal_goes_on(tmp_path):
    ended = stopped_run(tmp_path, "journal='kept.journal'")
    assert ended.returncode == 0, ended.stderr
    assert (tmp_path / "kept.journal").exists()
    case = whirl.Case(GOOD).set("integrate.transient", 20000).set("sweep.points", 400)
    with pytest.raises(whirl.BadInput):  # an existing journal is not replaced
        whirl.run(case, journal=tmp_path / "kept.journal", progress=False)
    part = whirl.open(tmp_path / "part.h5")["sweep"]
    whole = whirl.run(case, journal=tmp_path / "kept.journal", resume=True, progress=False)["sweep"]
    assert not (tmp_path / "kept.journal").exists() and len(whole.values) == 400
    chosen = part.point - 1
    for field in part:
        assert whole[field][chosen].tobytes() == part[field].tobytes(), field


def test_sentences_stay_whatever_fails_later():
    with pytest.raises(whirl.BadInput) as first:
        whirl.Case(GOOD).set("nothing", 1)
    for i in range(100):
        with pytest.raises(whirl.BadInput):
            whirl.Case(text=f"whirl: {i + 2}")
    assert "nothing" in str(first.value)


def test_no_warning_where_all_is_done():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert not whirl.run(whirl.Case(GOOD), progress=False).partial


def test_importing_takes_no_other_package():
    program = (
        "import sys, whirl; print([m for m in ('numpy', 'h5py', 'pandas', 'matplotlib', 'cffi') if m in sys.modules])"
    )
    out = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True, env=os.environ)
    assert out.stdout.strip() == "[]"


def test_outlines_have_parameters_and_values():
    outline = whirl.Case(GOOD).outline()
    assert np.allclose(outline["sweep"].values, [1.0, 1.75, 2.5, 3.25, 4.0])


ALARM = """
import gc, signal, sys, whirl

def boom(*_):
    raise TimeoutError

case = whirl.Case(sys.argv[1])
case.set("integrate.transient", 400000).set("integrate.steps_per_revolution", 8192)
signal.signal(signal.SIGALRM, boom)
signal.setitimer(signal.ITIMER_REAL, 0.5, 0.002)
try:
    whirl.run(case, threads=1, progress=lambda *about: None, journal=sys.argv[2])
except TimeoutError:
    signal.signal(signal.SIGALRM, signal.SIG_IGN)
    del case
    gc.collect()
    print("well")
"""


def test_a_signal_whose_handler_raises_ends_the_run(tmp_path):
    words = [sys.executable, "-c", ALARM, GOOD, tmp_path / "journal"]
    ended = subprocess.run(words, capture_output=True, text=True, timeout=60)
    assert (ended.returncode, ended.stdout) == (0, "well\n"), ended.stderr


AGAIN = """
import gc, os, signal, sys, threading, time, whirl

def boom(_number, frame):
    "Raises, and has every instruction of whirl from here on counted, of which one raises once more."
    left, which = [which_raises], __import__("whirl.running").running.__file__
    def trace(frame, event, _argument):
        frame.f_trace_opcodes = True
        if event == "opcode" and frame.f_code.co_filename == which:
            left[0] -= 1
            if left[0] == 0:
                seen.append((frame.f_code.co_name, frame.f_lineno))
                raise TimeoutError("again")
        return trace
    sys.settrace(trace)
    while frame:
        frame.f_trace, frame.f_trace_opcodes = trace, True
        frame = frame.f_back
    raise TimeoutError

signal.signal(signal.SIGALRM, boom)
seen, which_raises = [], 0
while len(seen) == which_raises:
    which_raises += 1
    case = whirl.Case(sys.argv[1])
    case.set("integrate.transient", 500).set("sweep.points", 4000)
    journal = f"{sys.argv[2]}.{which_raises}"
    def raise_soon():
        while not os.path.exists(journal):
            time.sleep(0.001)
        os.kill(os.getpid(), signal.SIGALRM)
    threading.Thread(target=raise_soon).start()
    try:
        whirl.run(case, threads=1, progress=lambda *about: None, journal=journal)
    except TimeoutError:
        pass
    sys.settrace(None)
    del case
    gc.collect()
    for thread in threading.enumerate():
        if thread.name == "whirl.run":
            thread.join(10)
            assert not thread.is_alive(), "the run goes on"
    assert os.path.exists(journal), "the journal was not closed as one that others go on with"
print(len(seen), *sorted({name for name, _ in seen}))
"""


def test_handlers_may_raise_anywhere(tmp_path):
    """Tests a signal handler that raises an exception, and raises another one at each of the following instructions in
    turn."""
    words = [sys.executable, "-c", AGAIN, GOOD, tmp_path / "journal"]
    ended = subprocess.run(words, capture_output=True, text=True, timeout=120)
    assert ended.returncode == 0, ended.stderr
    count, *names = ended.stdout.split()
    assert int(count) > 50 and {"wait", "outlast", "compute"} <= set(names), ended.stdout


def test_results_are_freed_at_once():
    result = whirl.run(whirl.Case(GOOD), progress=False)
    result.plot  # makes an object that refers to the result
    gone, array = weakref.ref(result), result["sweep"]["poincare/section"]
    owner = weakref.ref(result._source)
    del result
    assert gone() is None and array.shape[0] == 5 and owner() is None
    assert np.isfinite(array).any()


@pytest.mark.parametrize("threads", [None, "2", 2.5])
def test_threads_are_whole(threads):
    with pytest.raises(whirl.BadInput, match="expected a whole number"):
        whirl.run(whirl.Case(GOOD), threads=threads)


def test_cases_are_pickled_and_copied():
    case = whirl.Case(GOOD).set("kappa", 7)
    for other in (pickle.loads(pickle.dumps(case)), copy.copy(case), copy.deepcopy(case)):
        other.set("kappa", 9)
        assert (case.parameters["kappa"].value, other.parameters["kappa"].value) == (7.0, 9.0)
    with pytest.raises(TypeError, match="save"):
        pickle.dumps(case.outline())


LEAVING = """
import atexit, sys, threading

def look():
    print("left with", len(__import__("whirl.running").running._underway), "runs")

atexit.register(look)  # before that of whirl, so that it is called after it
import whirl
case = whirl.Case(sys.argv[1])
case.set("integrate.transient", 5000000)
ended = threading.Event()
work = lambda: whirl.run(case, threads=1, progress=lambda *about: ended.set())
threading.Thread(target=work, daemon=True).start()
ended.wait()
"""


def test_python_exit():
    """Tests that a run in a daemon thread is stopped and has ended before Python exits."""
    for _ in range(3):
        ended = subprocess.run([sys.executable, "-c", LEAVING, GOOD], capture_output=True, text=True, timeout=60)
        assert (ended.returncode, ended.stdout) == (0, "left with 0 runs\n"), ended.stderr


SUBINTERPRETER = '''
try:
    import _interpreters as interpreters
except ImportError:
    import _xxsubinterpreters as interpreters
import whirl
whirl.Case
interpreters.run_string(interpreters.create(), """
try:
    import whirl
except ImportError as refused:
    print(refused, flush=True)
""")
'''


def test_subinterpreters_are_refused_in_words():
    done = subprocess.run(
        [sys.executable, "-c", SUBINTERPRETER], capture_output=True, text=True, timeout=60, check=False
    )
    assert (
        done.stdout == "whirl works in the main interpreter of a program alone, not in a subinterpreter\n"
    ), done.stderr


def test_a_fork_during_a_run_is_refused_in_words(tmp_path):
    program = tmp_path / "forks.py"
    program.write_text(
        "import os, sys, threading, time, whirl\n"
        f"text = open({str(GOOD)!r}).read()\n"
        "going, forked = threading.Event(), threading.Event()\n"
        "def wait_for_the_fork(*_):\n"  # the run goes on until the fork is over, however long that takes
        "    going.set()\n"
        "    forked.wait()\n"
        "def run():\n"
        "    whirl.run(whirl.Case(text=text), threads=1, progress=wait_for_the_fork)\n"
        "threading.Thread(target=run, daemon=True).start()\n"
        "going.wait()\n"
        "if os.fork() == 0:\n"
        "    try:\n"
        "        whirl.run(whirl.Case(text=text), threads=1, progress=False)\n"
        "    except whirl.Error as refused:\n"
        "        print(refused, flush=True)\n"
        "    os._exit(0)\n"
        "os.wait()\n"
        "forked.set()\n"
    )
    done = subprocess.run([sys.executable, program], capture_output=True, text=True, timeout=60, check=False)
    assert "was forked during a run in another thread of its parent" in done.stdout, done.stderr


def test_cases_are_plain_files(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(whirl.BadInput, match="it is a pipe"):
        whirl.Case(tmp_path / "pipe")
    with pytest.raises(whirl.BadInput, match="it is a device"):
        whirl.Case("/dev/zero")
    with pytest.raises(whirl.BadInput, match="it is a pipe"):
        whirl.open(tmp_path / "pipe")
