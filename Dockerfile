# Dockerfile -- Suna with OpenFOAM on Debian, built as on any Debian: coupling/setup installs the packages
# and makes the OpenFOAM environment.
#
#   docker build -t suna .
#   docker run -it -v "$PWD":/work suna demPimpleFoam -help
#
# tests/install runs the RUN lines in a change root (./Alltest -long install).
# SPDX-License-Identifier: GPL-3.0-or-later

FROM debian:bookworm
ENV SUNA_CACHE=/opt/suna-openfoam

# packages and environment; made anew only when the set-up changes
COPY coupling/setup /opt/suna/coupling/setup
RUN bash -c '. /opt/suna/coupling/setup/environment' && rm -rf /var/lib/apt/lists/*

COPY . /opt/suna
RUN bash -c '. /opt/suna/coupling/setup/environment && /opt/suna/Allwmake -j -s'

WORKDIR /work
ENTRYPOINT ["bash", "-c", ". /opt/suna/coupling/setup/environment && exec \"$@\"", "suna"]
CMD ["bash"]
