"""`python -m instobj` is the `instobj` command."""

from instobj.cli.app import main

if __name__ == "__main__":
    main()
