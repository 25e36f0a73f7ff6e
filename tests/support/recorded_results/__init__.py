"""What functions returned for the arguments of the tests, on record: is it still the same?"""
