"""Long calls of the library, which Ctrl-C interrupts."""

import math
import sys
import threading
import time
from concurrent.futures import Future, wait
from typing import Any, Callable, Optional

# Intervals that one call flies before Python looks for an interrupt: 0.1 s with the slowest algorithm.
INTERVALS = 8192


class Progress:
    """A line on standard error, renewed each second: which part of the work is done, and the remaining time; without a whole, the time."""

    def __init__(self, what: str, whole: int = 0) -> None:
        self._what, self._whole, self._done = what, whole, 0
        self._lock = threading.Lock()
        self._begun_s = self._shown_s = time.monotonic()
        self._width = 0

    def add(self, parts: int) -> None:
        """From any thread."""
        with self._lock:
            self._done += parts

    def text(self, elapsed_s: float) -> str:
        if not self._whole:
            return f"{self._what}, {elapsed_s:.0f} s"
        done = self._done / self._whole
        text = f"{self._what}: {math.floor(100 * done)} %"
        return f"{text}, {math.ceil(elapsed_s * (1 / done - 1))} s left" if 0 < done < 1 else text

    def show(self) -> None:
        now_s = time.monotonic()
        if now_s - self._shown_s >= 1.0:
            self._shown_s = now_s
            self._write(self.text(now_s - self._begun_s))

    def clear(self) -> None:
        if self._width:
            self._write("")
            sys.stderr.write("\r")
            sys.stderr.flush()

    def _write(self, text: str) -> None:
        sys.stderr.write("\r" + text.ljust(self._width))
        sys.stderr.flush()
        self._width = len(text)


def in_background(call: Callable[[], Any], stop: Callable[[], Any] = bool, progress: Optional[Progress] = None) -> Any:
    """The answer of a call, which computes on a thread that does not keep the process alive. An interrupt ends the wait at once; stop()
    then ends the call."""
    future: "Future[Any]" = Future()

    def work() -> None:
        try:
            future.set_result(call())
        except BaseException as error:
            future.set_exception(error)

    try:
        threading.Thread(target=work, name="sins", daemon=True).start()
        while not future.done():
            wait([future], 0.1)  # without a limit, Windows would answer at its end
            if progress:
                progress.show()
    except BaseException:
        stop()
        raise
    finally:
        if progress:
            progress.clear()
    return future.result()
