"""What a worker process of a local cluster does first: Ctrl-C is for the program that started it.

Dask calls `dask_setup` of the module that `preload` names ("Customize Initialization" in the
documentation of distributed).
"""

import logging
import signal
from typing import Any


def dask_setup(_: Any) -> None:
    """Leave Ctrl-C and a closed terminal to the program, which ends its workers in good order.

    What Dask says of flights that are given up then is nothing to the user.
    """
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
