# Plays, checks and runs tournaments; no window system, no graphics card, an unprivileged user. docs/tournament-cluster.md
FROM python:3.11-slim-bookworm AS build
WORKDIR /source
COPY . .
RUN python -m venv /opt/rcj \
    && /opt/rcj/bin/pip install --no-cache-dir ".[cluster]"

FROM python:3.11-slim-bookworm
RUN useradd --create-home --uid 1000 rcj \
    && mkdir /work \
    && chown rcj:rcj /work
COPY --from=build /opt/rcj /opt/rcj
ENV PATH="/opt/rcj/bin:$PATH" LANG=C.UTF-8
USER rcj
WORKDIR /work
ENTRYPOINT ["rcj-challenge"]
CMD ["--help"]
