"""_core.py -- the core's objects behind a simulation, a case and its run: who may use them when, and
what they return as copies.

What the library returns lies in its own memory, which moves or goes with the next call that changes
the simulation, while Python may keep an array for ever. So nothing leaves this file that points into
it: arrays and texts are copies.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import re
import signal
import threading
from contextlib import contextmanager

import numpy

from ._arguments import SunaError
from ._library import ffi, lib

RAISED = 2000    # in the flag that ends an advance: a function of the caller raised an exception


def string(pointer):
    """A text of the library. Scenes and file names need not be UTF-8."""
    return "" if pointer == ffi.NULL else ffi.string(pointer).decode(errors="replace")


def check(status):
    if status:
        raise SunaError(string(lib.dem_error_text()))


def column(pointer, n, width=1, stride=None):
    """Numbers of the library as a read-only array, n or n x width: a copy."""
    kind = {"double": numpy.float64, "int64_t": numpy.int64,
            "uint16_t": numpy.uint16}[re.match(r"(\w+)", ffi.typeof(pointer).item.cname)[0]]
    shape = (n, width) if width > 1 else (n,)
    size = numpy.dtype(kind).itemsize
    array = numpy.empty(shape, kind)
    if n > 0:
        stride = stride or width*size
        raw = ffi.buffer(pointer, (n - 1)*stride + width*size)
        array[:] = numpy.ndarray(shape, kind, raw, strides=(stride, size)[:len(shape)])
    array.flags.writeable = False
    return array


class Core:
    """struct dem_case of one simulation until it starts, struct dem from then on. Each use is
    `with core.case("call") as c`, `with core.run() as d`, which starts the run if need be, or
    `with core.scene() as scene`. It is refused when the simulation is closed, while another thread
    is in a call of it (cffi lets other threads run), and in a function that an advance calls."""

    def __init__(self, comm):
        self._case, self._run = ffi.new("struct dem_case **"), ffi.new("struct dem **")
        self._lock, self._advances, self.closed = threading.RLock(), False, True
        check(lib.dem_case_create_fortran(self._case, -1 if comm is None else comm.py2f()))
        # as the core, which duplicates it too: the caller may free it
        self.closed, self._comm = False, comm.Dup() if comm else None

    @property
    def started(self):
        return self._run[0] != ffi.NULL

    @contextmanager
    def _use(self):
        if not self._lock.acquire(blocking=False):
            raise SunaError("the simulation is in use by another thread; use it from one thread at a "
                            "time")
        try:
            if self.closed:
                raise SunaError("the simulation is closed; create another one, for example from a "
                                "snapshot")
            if self._advances:
                raise SunaError("the simulation is advancing; a progress function must not use it, "
                                "only the time and the steps that it gets")
            yield
        finally:
            self._lock.release()

    def _require_one(self):
        if not self.started and self._case[0] == ffi.NULL:
            raise SunaError("the set-up of the simulation has failed; start again with another one")

    @contextmanager
    def case(self, what):
        with self._use():
            self._require_one()
            if self.started:
                raise SunaError(f"{what}: the simulation is set up already; call it before anything "
                                "that looks at particles or advances")
            yield self._case[0]

    @contextmanager
    def run(self):
        with self._use():
            self._require_one()
            if not self.started:
                check(lib.dem_start(self._case, self._run))
            yield self._run[0]

    @contextmanager
    def scene(self):
        with self._use():
            self._require_one()
            yield (lib.dem_scene_dict(self._run[0]) if self.started
                   else lib.dem_case_dict(self._case[0]))

    def close(self):
        if not self.closed:
            with self._use():
                self.closed = True
                lib.dem_case_free(self._case[0])
                lib.dem_free(self._run[0])
                self._case[0] = self._run[0] = ffi.NULL
                if self._comm is not None:
                    self._comm.Free()

    def advance(self, duration, progress, every):
        """dem_advance. An exception of progress ends it after a step, on all ranks, and is raised
        here."""
        fault = None

        def report(_, time, steps):
            nonlocal fault
            try:
                progress(time, steps)
            except BaseException as error:
                fault, asked[0] = error, RAISED

        call = ffi.NULL if progress is None else ffi.callback("void(void *, double, int64_t)", report)
        with self.run() as d, _interrupt() as asked:
            lib.dem_set_stop_flag(d, asked)
            lib.dem_set_progress(d, every, call, ffi.NULL)
            self._advances = True
            try:
                status = lib.dem_advance(d, duration)
            finally:
                self._advances = False
                lib.dem_set_progress(d, every, ffi.NULL, ffi.NULL)
                lib.dem_set_stop_flag(d, ffi.NULL)
            reason = max(asked[0], lib.dem_stopped(d))
        if status == 0 and self._comm is not None:
            # it may have been set on one rank in the last step, which the core does not tell others
            reason = max(self._comm.allgather(reason))
        if fault is not None:
            try:
                raise fault
            finally:
                fault = None    # its traceback holds this frame
        check(status)
        if reason == RAISED:
            raise SunaError("the progress function of another rank raised an exception, which ended "
                            "the advance; see that rank's message")
        if reason:
            raise KeyboardInterrupt


@contextmanager
def _interrupt():
    """The flag that ends an advance. While the core advances its own handler catches Ctrl-C and sets
    it: Python's runs only between two calls. In other threads than the main one, and where Python
    does not know the handler that it would have to restore, nothing is caught."""
    old = (signal.getsignal(signal.SIGINT)
           if threading.current_thread() is threading.main_thread() else None)
    if old is None:
        yield ffi.new("sig_atomic_t *")
        return
    caught = ffi.cast("sig_atomic_t *", lib.dem_catch_signals([signal.SIGTERM, signal.SIGUSR1], 2))
    caught[0] = 0
    try:
        yield caught
    finally:
        signal.signal(signal.SIGINT, old)
