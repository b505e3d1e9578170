# install.mk -- make install and uninstall: program, libraries, headers, Python packages, man pages.
#
#   make install PREFIX=/usr/local DESTDIR=     DESTDIR goes before every path, as packages need it
#   make install LIBDIR=/usr/lib/x86_64-linux-gnu PYTHONDIR=...     other folders
#   make uninstall                              with the same PREFIX, DESTDIR and folders
#   make dist                                   what a release has, in $(BUILD)/dist: the source of Suna at the present
#                                               commit; in python/ a source distribution and a wheel without MPI
#
# All files are first made in $(BUILD)/stage, below the paths that they will have; so install copies a
# tree, and uninstall knows what was copied. SPDX-License-Identifier: GPL-3.0-or-later

PREFIX     ?= /usr/local
BINDIR     ?= $(PREFIX)/bin
LIBDIR     ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include/suna
MANDIR     ?= $(PREFIX)/share/man
PYTHON     ?= $(firstword $(wildcard /usr/bin/python3) python3)
# where this Python looks for packages below the prefix
PYTHONDIR  ?= $(shell $(PYTHON) install/python_folder $(PREFIX))

VERSION   := $(shell sed -n 's/^\#define DEM_VERSION "\(.*\)"/\1/p' include/dem.h)
HEADERS   := $(sort $(wildcard include/*.h)) $(if $(filter no,$(MPI)),ranks/serial/mpi.h)
SONAME    := libdem.so.$(firstword $(subst ., ,$(VERSION)))
STAGE      = $(BUILD)/stage
PACKAGES   = suna suna_cost suna_import suna_plot
# what mpicc adds (Open MPI, MPICH), for programs that are compiled by others
MPI_CFLAGS = $(filter -I% -D% -pthread,$(COMPILER))
MPI_LIBS   = $(filter -L% -l% -pthread,$(COMPILER))

.PHONY: stage install uninstall dist

# fill TEMPLATE: into $(LIBDIR); in it the include folder as seen from that file, too
fill = sed -e 's|@VERSION@|$(VERSION)|g' -e 's|@PREFIX@|$(PREFIX)|g' -e 's|@LIBDIR@|$(LIBDIR)|g' \
    -e 's|@INCLUDEDIR@|$(INCLUDEDIR)|g' -e 's|@MPI_CFLAGS@|$(MPI_CFLAGS)|g' \
    -e 's|@MPI_LIBS@|$(MPI_LIBS)|g' -e 's|@SONAME@|$(SONAME)|g' \
    -e "s|@INCLUDE_FROM_CMAKE@|$$(realpath -ms --relative-to=$(LIBDIR)/cmake/suna $(INCLUDEDIR))|g" \
    install/$(1) > $(STAGE)$(LIBDIR)/$(2)

$(BUILD)/man/dem.1: $(BUILD)/dem $(SCRIPTS) $(BUILD)/libdem.so install/manpages $(wildcard ../python/suna_*/*.py)
	$(call say,man,$(@D))
	$Qrm -rf $(@D)
	$QPYTHONPATH=../python SUNA_LIBRARY=$(BUILD)/libdem.so SUNA_PYTHON=$(PYTHON) \
	    $(PYTHON) install/manpages $(@D) $(VERSION) $(BUILD)/dem

stage: all $(BUILD)/man/dem.1
	$Qtest -n "$(PYTHONDIR)" || { echo "make install needs python3, for the Python packages and the man pages;" \
	    "PYTHON=... names one" >&2; exit 1; }
	$(call say,stage,$(STAGE)$(PREFIX))
	$Qrm -rf $(STAGE)
	$Qinstall -d $(STAGE)$(BINDIR) $(STAGE)$(LIBDIR)/pkgconfig $(STAGE)$(LIBDIR)/cmake/suna
	$Qinstall $(BUILD)/dem $(SCRIPTS) $(STAGE)$(BINDIR)
	$Qinstall -m 644 -Dt $(STAGE)$(INCLUDEDIR) $(HEADERS)
	$Qinstall -m 644 $(LIBRARY) $(STAGE)$(LIBDIR)
	$Qinstall -m 644 $(BUILD)/libdem.so $(STAGE)$(LIBDIR)/libdem.so.$(VERSION)
	$Qln -s libdem.so.$(VERSION) $(STAGE)$(LIBDIR)/$(SONAME)
	$Qln -s $(SONAME) $(STAGE)$(LIBDIR)/libdem.so
	$Q$(call fill,suna.pc.in,pkgconfig/suna.pc)
	$Q$(call fill,sunaConfig.cmake.in,cmake/suna/sunaConfig.cmake)
	$Q$(call fill,sunaConfigVersion.cmake.in,cmake/suna/sunaConfigVersion.cmake)
	$Qcd ../python && find $(PACKAGES) -name '*.py' -o -name py.typed | xargs -I {} install -m 644 -D {} $(abspath $(STAGE))$(PYTHONDIR)/{}
	$Qinstall -m 644 -Dt $(STAGE)$(PYTHONDIR)/suna/include $(HEADERS)
	$Qln -s $$(realpath -ms --relative-to=$(PYTHONDIR)/suna $(LIBDIR))/$(SONAME) $(STAGE)$(PYTHONDIR)/suna/libdem.so
	$Qinstall -m 644 -Dt $(STAGE)$(MANDIR)/man1 $(BUILD)/man/*.1

install: stage
	$(call say,install,$(DESTDIR)$(PREFIX))
	$Qumask 022 && mkdir -p $(DESTDIR)/ && cp -R --remove-destination $(STAGE)/. $(DESTDIR)/

# our folders go, others stay
uninstall: stage
	$(call say,uninstall,$(DESTDIR)$(PREFIX))
	$Qcd $(STAGE) && find . ! -type d | while read -r file; do rm -f "$(DESTDIR)/$$file"; done
	$Qrm -rf $(patsubst %,$(DESTDIR)%,$(INCLUDEDIR) $(LIBDIR)/cmake/suna $(PACKAGES:%=$(PYTHONDIR)/%))

DIST = $(abspath $(BUILD))/dist
dist:
	$Qtest -z "$$(git status --porcelain -uno)" || { echo "make dist: commit the changes first; git status shows them" >&2; exit 1; }
	$(call say,dist,$(DIST))
	$Qrm -rf $(DIST) && mkdir -p $(DIST)/python
	$Qcd .. && git archive --prefix=suna-$(VERSION)/ HEAD | xz > $(DIST)/suna-$(VERSION).tar.xz
	$Qcd ../python && export SUNA_MPI=no && $(PYTHON) -c 'from setuptools.build_meta import build_sdist, build_wheel; \
	    build_sdist("$(DIST)/python"); build_wheel("$(DIST)/python")' > $(DIST)/log
	$Qcd $(DIST) && rm log && sha256sum *.tar.xz python/* > SHA256SUMS && cat SHA256SUMS
