cd /tmp/w/s6/obs; export PYTHONPATH=/tmp/w/s6/obs:/tmp/w/s6/obs/tools; exec /tmp/w/venv/bin/python "$@"
