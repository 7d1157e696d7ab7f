"""The one error of bad input: what the user gave cannot be used."""


class InputError(Exception):
    """Bad input; the message names the file, the key, its value and what is allowed.

    The command line prints the message as it is, without a traceback, and exits with 2.
    """
