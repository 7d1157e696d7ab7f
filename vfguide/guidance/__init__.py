"""Laws of guidance: from the state and a route to bank, load factor and path angle."""
