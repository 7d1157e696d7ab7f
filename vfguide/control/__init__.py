"""From a command of guidance to body rates and thrust, within the limits of the aircraft."""
