"""The live page: contacts and channels of a board, and their health, served to browsers."""
