"""_core.py -- the core's objects behind a simulation, a case and its run: who may use them when, and
what they return as copies.

What the library returns lies in its own memory, which moves or goes with the next call that changes
the simulation, while Python may keep an array for ever. So nothing leaves this file that points into
it: arrays and texts are copies.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import signal
import threading
import weakref
from contextlib import contextmanager

from ._arguments import SunaError
from ._library import ffi, lib
from .particles import Forces

# in the flag that ends an advance: the progress function, or one that gives forces, raised an exception
RAISED, FORCE_RAISED = 2000, 2001


def string(pointer):
    """A text of the library. Scenes and file names need not be UTF-8."""
    return "" if pointer == ffi.NULL else ffi.string(pointer).decode(errors="replace")


def check(status):
    if status:
        raise SunaError(string(lib.dem_error_text()))


class Core:
    """struct dem_case of one simulation until it starts, struct dem from then on. Each use is
    `with core.case("call") as c`, `with core.run() as d`, which starts the run if need be, or
    `with core.scene() as scene`. It is refused when the simulation is closed, while another thread
    is in a call of it (cffi lets other threads run), and in a function that an advance calls."""

    def __init__(self, comm):
        self._case, self._run = ffi.new("struct dem_case **"), ffi.new("struct dem **")
        self._lock, self._advances, self.closed = threading.RLock(), False, True
        self._views, self._lent = 0, []
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
                raise SunaError("the simulation is advancing; a progress function or a force must not "
                                "use it, only what it gets")
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

    def restart(self, describe, path):
        """Go on with the case that `describe(c)` describes, from the present state, which is written to
        the file of this path and read. After an error all is as before."""
        case, run = ffi.new("struct dem_case **"), ffi.new("struct dem **")
        with self.changing() as d:
            try:
                check(lib.dem_save(d, path))
                check(lib.dem_case_create_fortran(case, -1 if self._comm is None else self._comm.py2f()))
                describe(case[0])
                check(lib.dem_case_load(case[0], path))
                check(lib.dem_start(case, run))
                check(lib.dem_take_over(run[0], d))
            except BaseException:
                lib.dem_case_free(case[0])
                lib.dem_free(run[0])
                raise
            finally:
                if self._comm is not None:
                    self._comm.Barrier()
                if self.rank == 0:
                    os.remove(path)
            self._run[0] = run[0]
            lib.dem_free(d)

    @property
    def rank(self):
        return 0 if self._comm is None else self._comm.rank

    @property
    def single(self):
        return self._comm is None or self._comm.size == 1

    def shared(self, value):
        """The value of the first rank, on all."""
        return value if self._comm is None else self._comm.bcast(value)

    def any(self, call):
        """True on all ranks if call() is on one. If it raises an exception on one, all have one."""
        fault, value = None, 0
        try:
            value = int(bool(call()))
        except BaseException as error:
            fault, value = error, 2
        value = value if self._comm is None else max(self._comm.allgather(value))
        if fault is not None:
            raise fault
        if value == 2:
            raise SunaError("another rank raised an exception; see that rank's message")
        return bool(value)

    def close(self):
        if not self.closed:
            with self._use():
                if self.started:
                    self._leave(self._run[0])
                self.closed = True
                lib.dem_case_free(self._case[0])
                lib.dem_free(self._run[0])
                self._case[0] = self._run[0] = ffi.NULL
                if self._comm is not None:
                    self._comm.Free()

    # ---- arrays without copy ---------------------------------------------------------------------

    @contextmanager
    def view(self):
        """The view of the library, which no call may change meanwhile, and a function that makes an array
        in it."""
        view = ffi.new("struct dem_view *")
        with self.run() as d:
            lib.dem_view(d, view)
        self._views += 1
        try:
            yield view, lambda block, size: self._lend(block, size)
        finally:
            self._views -= 1

    def _lend(self, block, size):
        """A buffer in the library. Arrays in it hold it, so it lives as long as they do."""
        raw = ffi.buffer(block, size)    # numpy holds it, not the memoryview
        self._lent = [one for one in self._lent if one()] + [weakref.ref(raw)]
        return memoryview(raw).toreadonly()

    def _leave(self, d):
        """Before memory of the library may move or go: arrays in it keep it, the run goes on with
        another."""
        lent, self._lent = [one for one in self._lent if one()], []
        if not lent:
            return
        was = ffi.new("struct dem_view_arrays *")
        check(lib.dem_view_leave(d, was))
        blocks = [ffi.gc(pointer, lib.dem_view_free)
                  for pointer in (was.record, was.force, was.torque, was.orientation)]
        for buffer in (one() for one in lent):
            if buffer is not None:
                weakref.finalize(buffer, id, blocks).atexit = False

    @contextmanager
    def changing(self):
        """As run(), for calls that change the particles."""
        with self.run() as d:
            if self._views:
                raise SunaError("a view of the simulation is open; change and advance it after the block "
                                "of `with sim.view()`")
            self._leave(d)
            yield d

    # ---- advance ---------------------------------------------------------------------------------

    def advance(self, duration, progress, every, forces=()):
        """dem_advance. An exception of progress, or of a function that gives forces, ends it after a
        step, on all ranks, and is raised here. With functions that give forces, the state before the
        advance is put back after an exception of one of them and after a failure on all ranks, such as a
        force that is not a number; averages keep their samples."""
        fault = None

        def report(_, time, steps):
            nonlocal fault
            try:
                progress(time, steps)
            except BaseException as error:
                fault, asked[0] = error, RAISED

        def add(_, time, view, force, torque):
            nonlocal fault
            try:
                if fault is None:
                    for function in forces:
                        Forces(time, view, force, torque).ask(function)
            except BaseException as error:
                fault, asked[0] = error, FORCE_RAISED

        call = ffi.NULL if progress is None else ffi.callback("void(void *, double, int64_t)", report)
        ask = ffi.callback("void(void *, double, struct dem_view *, double *, double *)", add)
        with self.changing() as d, _interrupt() as asked:
            if forces:
                check(lib.dem_backup_every(d, 0))
            lib.dem_set_stop_flag(d, asked)
            lib.dem_set_progress(d, every, call, ffi.NULL)
            check(lib.dem_set_force(d, ask if forces else ffi.NULL, ffi.NULL))
            self._advances = True
            try:
                status = lib.dem_advance(d, duration)
                message = string(lib.dem_error_text()) if status else ""
            finally:
                self._advances = False
                lib.dem_set_progress(d, every, ffi.NULL, ffi.NULL)
                lib.dem_set_stop_flag(d, ffi.NULL)
                lib.dem_set_force(d, ffi.NULL, ffi.NULL)
            reason = max(asked[0], lib.dem_stopped(d))
            if self._comm is not None and lib.dem_ranks_agree(d):
                # it may have been set on one rank in the last step, which the core does not tell others
                reason = max(self._comm.allgather(reason))
            if forces and (reason == FORCE_RAISED or status and lib.dem_ranks_agree(d)):
                at = ffi.new("double *")
                check(lib.dem_restore(d, at))
                message += f"; the simulation is back at time {at[0]:.9g} s, before this advance"
        if fault is not None:
            try:
                raise fault
            finally:
                fault = None    # its traceback holds this frame
        if reason >= RAISED:
            raise SunaError("a function of another rank raised an exception, which ended the advance; "
                            "see that rank's message")
        if status:
            raise SunaError(message)
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
