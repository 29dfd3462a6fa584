#!/bin/bash
# source_date.sh COMMAND...: runs it with SOURCE_DATE_EPOCH, the time of the commit that is checked out, and with one umask, locale
# and time zone: what is packed has the same bytes wherever and whenever it is packed.
set -euo pipefail
cd "$(dirname "$0")/../.."
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
export SOURCE_DATE_EPOCH
export LC_ALL=C.UTF-8 TZ=UTC PYTHONDONTWRITEBYTECODE=1
umask 022
exec "$@"
