"""MAVLink bytes: message records, the codec, the tlog file."""
