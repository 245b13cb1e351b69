"""The error of the module."""


class Error(ValueError):
    """A call has failed; your arrays are as before.

    Attributes
    ----------
    status : str
        The kind of failure, such as ``'not seamless'`` or ``'invalid argument'``.
    reason : str
        What is wrong, and where.
    place : str or None
        The place alone, such as ``'face 12'``, ``'vertices 3 and 7'``, or ``'row 5 of F'``. Numbers
        are rows, from 0.
    remedy : str or None
        What to do about it.
    report : dict or None
        The measurements up to the failure, as functions return them with ``report=True``.
    """

    def __init__(self, reason, remedy=None, place=None, status="invalid argument", report=None):
        super().__init__(f"{reason}; {remedy}" if remedy else reason)
        self.reason = reason
        self.remedy = remedy
        self.place = place
        self.status = status
        self.report = report

    def __reduce__(self):
        return Error, (self.reason, self.remedy, self.place, self.status, self.report)
