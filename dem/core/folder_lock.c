/*
 * folder_lock.c -- one run at a time in a folder: a file `lock` with the process and the host of
 * the run, locked by the kernel as long as the process lives.
 *
 * A run that was killed leaves the file but not the kernel's lock, so the next run takes it over.
 * On a file system without locks the process is looked for instead, on the same host.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* fcntl, gethostname, kill */

#include "core/error.h"
#include "dem_tables.h"
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum
{
    TRIES = 10  /* of a file that its owner removes at the same time */
};

static void host_name(char host[256])
{
    if (gethostname(host, 255) != 0)
    {
        host[0] = '\0';
    }
    host[255] = '\0';
}

/* The kernel's lock: 0 when this process has it, EAGAIN when another one has, else the reason why
   the file system has none. */
static int lock_file(int file)
{
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};

    errno = 0;
    if (fcntl(file, F_SETLK, &whole) == 0)
    {
        return 0;
    }
    return errno == EACCES ? EAGAIN : errno;
}

/* "process 123 on host box" from the content; "" when there is none. */
static void read_owner(int file, char owner[300], long *pid, char host[256])
{
    char text[300];
    const ssize_t n = pread(file, text, sizeof text - 1, 0);

    text[n > 0 ? n : 0] = '\0';
    *pid = 0;
    host[0] = owner[0] = '\0';
    if (sscanf(text, "%ld %255s", pid, host) == 2)
    {
        snprintf(owner, 300, "process %ld on host %s", *pid, host);
    }
}

/* Without locks of the kernel: 1 when the process of this host is gone. */
static int is_over(long pid, const char *host)
{
    char here[256];

    host_name(here);
    return pid <= 0 || (strcmp(here, host) == 0 && kill((pid_t)pid, 0) != 0 && errno == ESRCH);
}

/* 1 when the file of this name is still the one that was opened. */
static int is_same_file(int file, const char *path)
{
    struct stat opened, named;

    return fstat(file, &opened) == 0 && stat(path, &named) == 0 && opened.st_dev == named.st_dev
        && opened.st_ino == named.st_ino;
}

static int write_owner(int file)
{
    char text[300], host[256];

    host_name(host);
    const int n = snprintf(text, sizeof text, "%ld %s\n", (long)getpid(), host[0] ? host : "?");

    return ftruncate(file, 0) == 0 && pwrite(file, text, (size_t)n, 0) == n;
}

/* Lock an open file; *again: 1 when its owner has removed it meanwhile. */
static int take(struct dem_folder_lock *l, const char *folder, int *again)
{
    const int reason = lock_file(l->file);
    char host[256];
    long pid;

    read_owner(l->file, l->before, &pid, host);
    DEM_REQUIRE(reason != EAGAIN && (reason == 0 || is_over(pid, host)), DEM_ERROR_STATE,
                "another run writes into the folder %s: %s; give this run another folder, or wait%s",
                folder, l->before[0] ? l->before : "its process is not known",
                reason == EAGAIN ? "" : "; if it has ended, remove the file lock there");
    *again = !is_same_file(l->file, l->path);
    DEM_REQUIRE(*again || write_owner(l->file), DEM_ERROR_FILE, "cannot write %s: %s", l->path,
                strerror(errno));
    return DEM_OK;
}

int dem_folder_lock(struct dem_folder_lock *l, const char *folder)
{
    int again = 1;

    for (int k = 0; k < TRIES && again; k++)
    {
        snprintf(l->path, sizeof l->path, "%s/lock", folder);
        l->file = open(l->path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (l->file < 0)
        {
            l->file = 0;
            return dem_error(DEM_ERROR_FILE, "cannot write %s: %s; give another folder", l->path,
                             strerror(errno));
        }
        const int status = take(l, folder, &again);

        if (status || again)
        {
            (void)close(l->file);
            l->file = 0;
        }
        DEM_TRY(status);
    }
    DEM_REQUIRE(!again, DEM_ERROR_STATE, "other runs take and remove %s all the time; give another "
                "folder", l->path);
    return DEM_OK;
}

void dem_folder_unlock(struct dem_folder_lock *l)
{
    if (l->file > 0)
    {
        (void)remove(l->path);    /* before the lock ends: no other run holds this file then */
        (void)close(l->file);
        l->file = 0;
    }
}
