"""The `instobj` command as `python -m instobj`."""

from instobj.cli.app import main

if __name__ == "__main__":
    main()
