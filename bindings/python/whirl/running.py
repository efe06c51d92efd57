"""Computes the result of a case, with progress. Ctrl-C stops a run and keeps its finished points."""

from __future__ import annotations

import _thread
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

from ._library import STOPPED, check, ensure_allowed, ffi, forbid, lib, path_bytes, text
from ._memory import MemorySource
from .case import Case
from .errors import BadInput
from .result import Result

__all__ = ["run"]

_MAX_THREADS = 1024  # limit of whirl_job_threads


_underway: set[_Work] = set()
_leaving = threading.Event()  # Python is exiting: no new run may begin


def _after_fork() -> None:
    """Forbids the library in a process that was forked during a run: it lacks the run's threads, and its locks are in
    an arbitrary state."""
    if _underway:
        _underway.clear()
        forbid(
            "this process was forked during a run in another thread of its parent, so that the library is in no known "
            "state: begin processes before runs, or with multiprocessing's 'spawn' or 'forkserver'"
        )


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork)


@atexit.register
def _stop_all() -> None:
    """Stops the runs of daemon threads before Python exits and unloads the library."""
    _leaving.set()
    left = list(_underway)
    for work in left:
        lib.whirl_job_stop(work.job)
    for work in left:
        work.outlast()


class _Bar:
    """A bar of tqdm, or one line on standard error without tqdm. It shows the share of revolutions, which estimates the
    time best."""

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
    """Opens a journal at ``path`` of a run whose outline ``describe`` gives, and yields its store; afterwards closes
    it, and removes it if all is done."""
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
            yield lib.whirl_journal_store(out[0]), lambda: ended.append(True)
        finally:
            check((lib.whirl_journal_remove if ended else lib.whirl_journal_close)(out[0]))
    finally:
        lib.whirl_result_free(outline[0])


@contextmanager
def _stopped_by_ctrl_c(job, outcome):
    """Makes Ctrl-C, also repeated, ask the job to stop, instead of raising an exception in this thread."""

    def stop(_number, _frame):
        outcome["interrupted"] = True
        lib.whirl_job_stop(job)

    # Do nothing in other threads, which get no signals, or if the handler is not Python's and could not be restored.
    if threading.current_thread() is not threading.main_thread() or signal.getsignal(signal.SIGINT) is None:
        yield
        return
    earlier = signal.signal(signal.SIGINT, stop)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, earlier)


class _Work:
    """A run on a thread of its own, as Python's signal handlers do not run during a call of the library. The thread
    owns all objects of the run: whatever is raised in the thread that waits for it, nothing is freed before the run
    has ended.

    Handlers may also raise within methods of threading, which leaves its locks in an arbitrary state and lets threads
    seem ended. The wait therefore ends by a flag of this class, and uses a bare lock only to sleep."""

    def __init__(self, job, borrowed, describe, journal, resume, started, threads):
        self.job, self.borrowed = job, borrowed
        self.describe, self.journal, self.resume = describe, journal, resume
        self.started, self.threads = started, threads
        self.outcome, self.over, self.gate = {}, False, threading.Lock()
        self.gate.acquire()
        self.worker = threading.Thread(target=self._work, name="whirl.run")

    def wait(self):
        """Runs the job, waits for it, and returns its outcome."""
        try:
            with _stopped_by_ctrl_c(self.job, self.outcome):
                _thread.start_new_thread(
                    self._begin, ()
                )  # not threading.Thread, whose start a signal handler could interrupt
                while not self.over:
                    self.gate.acquire(timeout=0.2)
        except BaseException:  # an exception of another signal's handler
            lib.whirl_job_stop(self.job)
            self.outlast()
            raise
        if "raised" in self.outcome:
            raise self.outcome.pop("raised")
        return self.outcome.pop("result")

    def outlast(self):
        """Waits for the end even if signal handlers raise exceptions."""
        while not self.over:
            try:
                self.gate.acquire(timeout=0.2)
            except BaseException:  # noqa: B036 (the first exception, or the result, matters)
                pass

    def _begin(self):
        try:
            self.worker.start()
        except BaseException as raised:
            self._end(raised)

    def _work(self):
        raised = None
        _underway.add(self)
        try:
            if not _leaving.is_set():
                self._run()
        except BaseException as caught:
            raised = caught
        _underway.remove(self)
        self._end(raised)

    def _end(self, raised):
        if raised is not None:
            self.outcome.setdefault("raised", raised)
        self.over = True
        self.gate.release()

    def _run(self):
        out, outcome = ffi.new("whirl_result **"), self.outcome
        prepared = lib.whirl_job_prepare(self.job)
        if prepared.code:
            outcome.update(code=prepared.code, message=text(prepared.message))
            if "raised" not in outcome:
                _finish(None, outcome, self.started, self.threads)
            return
        with _journal(self.describe, self.journal, self.resume) as (store, all_done):
            lib.whirl_job_keep(self.job, store)
            status = lib.whirl_job_run(self.job, out)
            source = MemorySource(out[0]) if out[0] != ffi.NULL else None
            outcome.update(code=status.code, message=text(status.message))
            if "raised" not in outcome:
                outcome["result"] = _finish(source, outcome, self.started, self.threads)
                if not source.partial:
                    all_done()


def _whole(number, what):
    try:
        return operator.index(number)
    except TypeError:
        raise BadInput(f"{what} is {number!r}, expected a whole number") from None


def _now():
    return datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")


def _teller(tell, job, outcome):
    """Makes a callback for the library. An exception in it stops the run and is raised at the run's end."""

    def keep(kind, value, trace):
        outcome.setdefault("raised", value)
        lib.whirl_job_stop(job)

    @ffi.callback("void(void *, const char *, double, double, double, double, double)", onerror=keep)
    def report(_context, stage, done, total, revolutions, all_revolutions, _seconds):
        if "raised" not in outcome:
            tell(text(stage), done, total, revolutions, all_revolutions)

    return report


def run(
    case: Case | str | os.PathLike | dict,
    *,
    threads: int = 0,
    progress: bool | Callable[[str, float, float, float, float], object] | None = None,
    journal: str | os.PathLike | None = None,
    resume: bool = False,
) -> Result:
    """Computes the study of a case.

    Ctrl-C stops a run; its finished points are returned as a partial result (``result.partial``) with a warning.

    Parameters
    ----------
    case : Case, or what Case() takes
        The case to compute. Another thread must not change it meanwhile.
    threads : int
        Number of threads; 0: all cores. No bit of the result depends on it.
    progress : bool or callable, optional
        True shows a bar; None shows it if standard error is a terminal, and in a notebook. A callable gets ``(stage,
        points_done, points_total, revolutions_done, revolutions_total)`` a few times a second.
    journal : path, optional
        File that keeps finished points during the run, so that ``resume=True`` can continue a run that was stopped or
        killed. It is removed when all is done.
    resume : bool
        Whether to continue from an existing journal; otherwise an existing journal is an error.

    Returns
    -------
    Result
        Warnings of the library are shown as ``UserWarning``, and are in ``result.warnings``.

    Raises
    ------
    BadInput, OutOfMemory, FileFailure, NumericalFailure
        With the library's message.
    """
    case = case if isinstance(case, Case) else Case(case)
    return compute(
        lambda out: lib.whirl_job_new(case._handle, out),
        lambda out: lib.whirl_case_outline(case._handle, out),
        case,
        threads=threads,
        progress=progress,
        journal=journal,
        resume=resume,
    )


def compute(
    new_job: Callable,
    describe: Callable,
    borrowed: object,
    *,
    threads: int,
    progress: bool | Callable[[str, float, float, float, float], object] | None,
    journal: str | os.PathLike | None,
    resume: bool,
) -> Result:
    """Runs a job that ``new_job`` makes and returns its result. ``borrowed``: objects that must live as long as the
    job; ``describe`` gives the outline for a journal; other arguments as for run."""
    ensure_allowed()
    started, out = _now(), ffi.new("whirl_job **")
    check(new_job(out))
    job = ffi.gc(out[0], lib.whirl_job_free)
    threads = _whole(threads, "the number of threads")
    if not 0 <= threads <= _MAX_THREADS:
        raise BadInput(f"the number of threads is {threads}, expected 0 (all cores) to {_MAX_THREADS}")
    check(lib.whirl_job_threads(job, threads))
    bar = _Bar() if (progress and not callable(progress)) or (progress is None and sys.stderr.isatty()) else None
    tell = progress if callable(progress) else bar.show if bar else None
    work = _Work(job, borrowed, describe, journal, resume, started, threads)
    work.report = _teller(tell, job, work.outcome) if tell else ffi.NULL
    lib.whirl_job_progress(job, work.report, ffi.NULL)
    try:
        result = work.wait()
    finally:
        lib.whirl_job_stop(job)  # needed if a signal handler raises just before or after work.wait()
        if bar:
            bar.close()
    for words in result.warnings:
        warnings.warn(words, stacklevel=3)
    if result.partial:
        warnings.warn(f"{work.outcome['message']}: the result is partial", stacklevel=3)
    return result


def _finish(source, outcome, started, threads):
    """Returns the result of a finished job, or raises its exception."""
    if source is None:
        if outcome.get("interrupted") and outcome["code"] == STOPPED:
            raise KeyboardInterrupt
        check(_Status(outcome["code"], outcome["message"]))
    for name, value in (("program", "Python"), ("started", started), ("finished", _now()), ("threads", str(threads))):
        check(lib.whirl_result_add_fact(source.handle, name.encode(), value.encode()))
    return Result(source)


class _Status:
    """A status made from a code and a text."""

    def __init__(self, code, message):
        self.code, self.message = code, ffi.new("char[]", message.encode())
