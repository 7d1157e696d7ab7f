"""Settings of every test run."""

from hypothesis import settings

# No deadline: the first call of a compiled function compiles it.
settings.register_profile("vfguide", deadline=None, derandomize=True)
settings.load_profile("vfguide")
