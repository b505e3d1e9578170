/*
 * folder_lock.h -- one run at a time in a folder: a file `lock` with the process and the host of the
 * run, locked by the kernel as long as the process lives.
 *
 * A run that was killed leaves the file but not the kernel's lock, so the next run takes it over. On a
 * file system without locks the process is looked for instead, on the same host.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_CORE_FOLDER_LOCK_H
#define DEM_CORE_FOLDER_LOCK_H

struct dem_folder_lock
{
    int file;               /* descriptor; 0: not locked */
    char path[640];
    char before[300];       /* "process 123 on host box" of a run that has left its lock; or "" */
};

/* Lock a folder, which must exist. DEM_ERROR_STATE when another run has locked it. */
int dem_folder_lock(struct dem_folder_lock *, const char *folder);

/* Remove the file; nothing when there is no lock. */
void dem_folder_unlock(struct dem_folder_lock *);

#endif
