"""Control: from a command of guidance to body rates and thrust, within the aircraft's limits."""
