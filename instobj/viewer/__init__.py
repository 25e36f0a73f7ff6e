"""The object in three dimensions, in the report: its scene as numbers, and the page's program."""
