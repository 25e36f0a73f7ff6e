"""The dialogue that brings a newly soldered object up, and what it leaves behind."""
