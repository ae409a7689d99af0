"""Long calls of the library, which Ctrl-C interrupts."""

import threading
from concurrent.futures import Future, wait
from typing import Any, Callable

# Intervals that one call flies before Python looks for an interrupt: 0.1 s with the slowest algorithm.
INTERVALS = 8192


def in_background(call: Callable[[], Any], stop: Callable[[], Any] = bool) -> Any:
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
    except BaseException:
        stop()
        raise
    return future.result()
