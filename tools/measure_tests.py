"""Processor time of the tests, by module: which of them are slow.

    python tools/measure_tests.py [OPTION OF PYTEST ...]

Runs pytest with these options, in one process, and prints a line for each module, the dearest
first: what its tests took [s], with their set-up and the programs that they started. That includes
the loading of compiled code that no module before it has called; what is compiled anew counts too,
so the second run tells. What collecting the tests took comes last.
"""

import resource
import sys
from collections import Counter
from collections.abc import Generator

import pytest


def processor_time() -> float:
    """Processor time of this process, and of those that it started and that have ended [s]."""
    each = map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(usage.ru_utime + usage.ru_stime for usage in each)


class Times:
    """A plugin of pytest that adds up processor times."""

    def __init__(self) -> None:
        self.spent = Counter[str]()
        """Processor time of each module, by its path [s]."""
        self.collecting = 0.0
        """Processor time of importing the modules and finding their tests [s]."""

    @pytest.hookimpl(wrapper=True, tryfirst=True)
    def pytest_collection(self) -> Generator[None, object, object]:
        """Time the collection."""
        before = processor_time()
        result = yield
        self.collecting = processor_time() - before
        return result

    @pytest.hookimpl(wrapper=True, tryfirst=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Generator[None, object, object]:
        """Time a test with its set-up."""
        before = processor_time()
        result = yield
        module = item.path.relative_to(item.config.rootpath).as_posix()
        self.spent[module] += processor_time() - before
        return result


def main() -> None:
    """Run the tests and print the table."""
    times = Times()
    status = pytest.main(["-q", *sys.argv[1:]], plugins=[times])
    for module, seconds in times.spent.most_common():
        print(f"{seconds:8.2f}  {module}")
    print(f"{times.collecting:8.2f}  collecting")
    print(f"{processor_time():8.2f}  in all")
    sys.exit(status)


if __name__ == "__main__":
    main()
