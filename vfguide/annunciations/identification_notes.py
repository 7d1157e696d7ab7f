"""Notes of an identification flight."""

from vfguide.aircraft.identification import Identified

TESTING = "test flight: {what}"
"""Note on a leg of the identification flight."""
NO_ROOM = "no room for a test flight here: flown with what is known of the aircraft"
"""Note where there is no room for an identification flight."""
BROKEN_OFF = "test flight broken off, something is in its way: nothing was measured"
"""Note where an identification flight is broken off."""
MEASURED = "measured: {names}"
"""Note of the estimates that are used."""
UNSEEN = "not seen well enough, flown as it was known before: {names}"
"""Note of the estimates that are not used."""


def identified_notes(found: Identified) -> list[str]:
    """Notes of the estimates of an identification flight."""
    seen = [str(each) for each in found.estimates if each.used]
    unseen = [each.key for each in found.estimates if not each.used]
    lists = ((MEASURED, seen), (UNSEEN, unseen))
    return [note.format(names=", ".join(names)) for note, names in lists if names]
