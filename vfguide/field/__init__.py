"""The vector fields of the paper, the attitude they define and the rate law."""
