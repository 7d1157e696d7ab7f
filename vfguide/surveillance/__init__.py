"""Who else flies: reports of other aircraft, the picture they make, alerts."""
