"""The terminal: what commands print there, how they end, and signals that ask them to."""
