"""Records of flights, and how they are judged."""
