"""A proxy between `vfguide sim` and `vfguide fly` that alters what the autopilot sends."""

import select
import socket
import threading
import time

from altered import Alter, Alteration
from programs import companion_port, offboard_port

LOOPBACK = "127.0.0.1"


class Proxy:
    """A thread that passes datagrams on, altered on the way to the companion."""

    def __init__(self, sysid: int, alter: Alter):
        self._autopilot = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._autopilot.bind((LOOPBACK, companion_port(sysid)))
        self._companion = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._companion.bind((LOOPBACK, 0))
        self._peer = (LOOPBACK, offboard_port(sysid))
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
            free.bind((LOOPBACK, 0))
            self._port = free.getsockname()[1]
        self._alteration = Alteration(alter)
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run)

    @property
    def url(self) -> str:
        """Where the companion listens."""
        return f"udpin:{LOOPBACK}:{self._port}"

    def _run(self) -> None:
        sockets = [self._autopilot, self._companion]
        while not self._ended.is_set():
            for ready in select.select(sockets, [], [], 0.1)[0]:
                try:
                    data, _ = ready.recvfrom(65_535)
                except ConnectionRefusedError:
                    continue
                if ready is self._companion:
                    self._autopilot.sendto(data, self._peer)
                elif altered := self._alteration.altered(time.monotonic_ns() // 1000, data):
                    self._companion.sendto(altered, (LOOPBACK, self._port))

    def __enter__(self) -> "Proxy":
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        self._thread.join()
        self._autopilot.close()
        self._companion.close()
