"""vfguide: vector-field guidance of fixed-wing aircraft over MAVLink."""

__version__ = "0.1.0"
