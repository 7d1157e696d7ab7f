"""The companion: decoded messages in, setpoints out. No socket, clock or thread."""
