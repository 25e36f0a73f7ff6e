"""Commands and studies show what they write; what statistics are worth is tested in `estimator`."""

from tests.support import smaller_statistics

smaller_statistics.install()
