"""What a worker process of a local cluster does first: it keeps silent.

Dask calls `dask_setup` of the module that `preload` names ("Customize Initialization" in the
documentation of distributed).
"""

import logging
from typing import Any


def dask_setup(_: Any) -> None:
    """Let Dask tell nothing: of flights that are given up when the user ends a campaign."""
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
