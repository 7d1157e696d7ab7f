"""The error of bad input from the user."""


class InputError(Exception):
    """Bad input; the message names the file, the key, the value and what is allowed.

    The command line prints the message as it is, without a traceback, and exits with 2.
    """
