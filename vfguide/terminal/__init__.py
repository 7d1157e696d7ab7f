"""The terminal: what commands print, how they end, and the signals that ask them to end."""
