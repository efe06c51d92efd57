"""Runs: from a case to its result, with progress, stopped by Ctrl-C without losing what is done."""

from __future__ import annotations

import atexit
import datetime
import operator
import os
import signal
import sys
import threading
import warnings
from collections.abc import Callable
from contextlib import contextmanager

from ._library import STOPPED, check, ffi, lib, path_bytes, text
from ._memory import MemorySource
from .case import Case
from .errors import BadInput
from .result import Result

__all__ = ["run"]

_MOST_THREADS = 1024  # as whirl_job_threads has it


_underway: dict[threading.Event, object] = {}  # jobs, by what is set when all of a run has ended


@atexit.register
def _stop_all() -> None:
    """Runs of threads that do not outlive Python (daemons) end before it does: it would take the library from them."""
    for job in list(_underway.values()):
        lib.whirl_job_stop(job)
    for ended in list(_underway):
        ended.wait()


class _Bar:
    """A bar of tqdm, or one line on standard error where tqdm is missing; in revolutions, which tell time best."""

    def __init__(self):
        try:
            from tqdm.auto import tqdm

            self.bar = tqdm(
                total=1.0, unit=" points", bar_format="{desc} {percentage:3.0f}%|{bar}| {elapsed}<{remaining}"
            )
        except ImportError:
            self.bar = None

    def show(self, stage, done, total, revolutions, all_revolutions):
        share = revolutions / all_revolutions if all_revolutions > 0 else 1.0
        words = f"{stage}: {done:.0f} of {total:.0f} points"
        if self.bar is not None:
            self.bar.set_description_str(words, refresh=False)
            self.bar.n = min(share, 1.0)
            self.bar.refresh()
        elif sys.stderr.isatty():
            print(f"\r{words}, {100 * share:.0f} %  ", end="", file=sys.stderr, flush=True)

    def close(self):
        if self.bar is not None:
            self.bar.close()
        elif sys.stderr.isatty():
            print(file=sys.stderr)


@contextmanager
def _journal(describe, path, resume):
    """The keeper of a journal at ``path``, of what ``describe`` gives the outline; afterwards it is closed, and removed
    where all is done."""
    if path is None:
        yield ffi.NULL, lambda: None
        return
    outline, out = ffi.new("whirl_result **"), ffi.new("whirl_journal **")
    check(describe(outline))
    try:
        begin = lib.whirl_journal_resume if resume and os.path.exists(path) else lib.whirl_journal_begin
        check(begin(path_bytes(path), outline[0], out))
        ended = []
        try:
            yield lib.whirl_journal_keeper(out[0]), lambda: ended.append(True)
        finally:
            check((lib.whirl_journal_remove if ended else lib.whirl_journal_close)(out[0]))
    finally:
        lib.whirl_result_free(outline[0])


@contextmanager
def _stopped_by_ctrl_c(job, outcome):
    """Ctrl-C, however often, asks the job to stop, in the place of an exception wherever this thread is."""

    def stop(_number, _frame):
        outcome["interrupted"] = True
        lib.whirl_job_stop(job)

    # Other threads get no signals; a handler that is not Python's could not be put back.
    if threading.current_thread() is not threading.main_thread() or signal.getsignal(signal.SIGINT) is None:
        yield
        return
    earlier = signal.signal(signal.SIGINT, stop)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, earlier)


def _wait(job, outcome):
    """Runs the job on a thread of its own, for Python's handlers of signals wait for calls of the library."""
    out, ended = ffi.new("whirl_result **"), threading.Event()

    def work():
        try:
            status = lib.whirl_job_run(job, out)
            outcome.update(code=status.code, message=text(status.message), result=out[0])
        finally:
            ended.set()

    worker = threading.Thread(target=work, name="whirl.run")
    try:
        with _stopped_by_ctrl_c(job, outcome):
            worker.start()
            while not ended.wait(0.2):
                pass
    except BaseException:  # of a handler of another signal, say: nothing may be freed that the job works with
        lib.whirl_job_stop(job)
        _join(worker)
        lib.whirl_result_free(out[0])
        raise
    _join(worker)


def _join(worker):
    """Waits for the end of a thread, whatever handlers of signals raise meanwhile."""
    while worker.is_alive():
        try:
            worker.join()
        except BaseException:  # noqa: B036 (the first one, or the result, is what counts)
            pass


def _whole(number, what):
    try:
        return operator.index(number)
    except TypeError:
        raise BadInput(f"{what} is {number!r}, expected a whole number") from None


def _now():
    return datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")


def _teller(tell, job, outcome):
    """A callable for the library. What it raises stops the run and is raised at its end."""

    def keep(kind, value, trace):
        outcome.setdefault("raised", value)
        lib.whirl_job_stop(job)

    @ffi.callback("void(void *, const char *, double, double, double, double, double)", onerror=keep)
    def told(_context, stage, done, total, revolutions, all_revolutions, _seconds):
        if "raised" not in outcome:
            tell(text(stage), done, total, revolutions, all_revolutions)

    return told


def run(
    case: Case | str | os.PathLike | dict,
    *,
    threads: int = 0,
    progress: bool | Callable[[str, float, float, float, float], object] | None = None,
    journal: str | os.PathLike | None = None,
    resume: bool = False,
) -> Result:
    """Computes the study of a case.

    Ctrl-C ends a run cleanly: what is done comes back as a partial result (``result.partial``) with a warning.

    Parameters
    ----------
    case : Case, or what Case() takes
        What is computed. Not to be changed by another thread meanwhile.
    threads : int
        0: all cores. No bit of the result depends on it.
    progress : bool or callable, optional
        True shows a bar, None where standard error is a terminal or in a notebook. A callable is told
        ``(stage, points_done, points_total, revolutions_done, revolutions_total)`` a few times a second.
    journal : path, optional
        Finished points are kept there while the run goes on, so that ``resume=True`` goes on from a journal that a run
        left (also one that was killed). It is removed when all is done.
    resume : bool
        Whether a journal that is there is gone on with; without it a journal that is there is an error.

    Returns
    -------
    Result

    Raises
    ------
    BadInput, OutOfMemory, FileFailure, NumericalFailure
        With the library's sentence.
    """
    case = case if isinstance(case, Case) else Case(case)
    return compute(
        lambda out: lib.whirl_job_new(case._handle, out),
        lambda out: lib.whirl_case_outline(case._handle, out),
        threads=threads,
        progress=progress,
        journal=journal,
        resume=resume,
    )


def compute(
    new_job: Callable,
    describe: Callable,
    *,
    threads: int,
    progress: bool | Callable[[str, float, float, float, float], object] | None,
    journal: str | os.PathLike | None,
    resume: bool,
) -> Result:
    """The result of a job that ``new_job`` makes, and of which ``describe`` gives the outline; the rest as for run."""
    started, outcome = _now(), {}
    out = ffi.new("whirl_job **")
    check(new_job(out))
    job = ffi.gc(out[0], lib.whirl_job_free)
    threads = _whole(threads, "the number of threads")
    if not 0 <= threads <= _MOST_THREADS:
        raise BadInput(f"the number of threads is {threads}, expected 0 (all cores) to {_MOST_THREADS}")
    check(lib.whirl_job_threads(job, threads))
    bar = _Bar() if (progress and not callable(progress)) or (progress is None and sys.stderr.isatty()) else None
    tell = progress if callable(progress) else bar.show if bar else None
    told = _teller(tell, job, outcome) if tell else ffi.NULL
    lib.whirl_job_progress(job, told, ffi.NULL)
    over = threading.Event()
    _underway[over] = job
    try:
        with _journal(describe, journal, resume) as (keeper, ended):
            lib.whirl_job_keep(job, keeper)
            _wait(job, outcome)
            result = _finish(outcome, started, threads)
            if not result.partial:
                ended()
    finally:
        del _underway[over]
        over.set()
        if bar:
            bar.close()
    if result.partial:
        warnings.warn(f"{outcome['message']}: the result is partial", stacklevel=3)
    return result


def _finish(outcome, started, threads):
    """The result of a job that has ended, or the exception."""
    if "raised" in outcome:
        lib.whirl_result_free(outcome["result"])
        raise outcome["raised"]
    if outcome["result"] == ffi.NULL:
        if outcome.get("interrupted") and outcome["code"] == STOPPED:
            raise KeyboardInterrupt
        check(_Status(outcome["code"], outcome["message"]))
    source = MemorySource(outcome["result"])
    for name, value in (("program", "Python"), ("started", started), ("finished", _now()), ("threads", str(threads))):
        check(lib.whirl_result_add_fact(source.handle, name.encode(), value.encode()))
    return Result(source)


class _Status:
    """A status whose message is a text already."""

    def __init__(self, code, message):
        self.code, self.message = code, ffi.new("char[]", message.encode())
