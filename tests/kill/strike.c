/* A library that is loaded before libc (LD_PRELOAD) and kills a process, or makes a call fail, at
 * the n-th call that concerns files.
 *   STRIKE_AT=n      the call's number, from 1; 0 or unset: calls are only counted
 *   STRIKE_HOW=how   kill: SIGKILL before the call
 *                    half: as kill, but a write first writes half of its bytes
 *                    a number: the call fails with that errno
 *                    full: this call and all later ones that need disk space fail as on a full disk
 *                    readonly: this call and all later ones that change files fail
 *   STRIKE_LOG=file  receives the names of all calls, a line each, if calls are only counted
 * The functions are those that `nm -D --undefined-only build/matc` lists. */
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

static atomic_long calls;
static long strike_at;
static int strike_errno;
static bool kills, half, full, readonly, ready;

static char names[1 << 16];
static size_t used;

static void note(const char *name)
{
    int size = snprintf(names + used, sizeof names - used, "%s\n", name);
    used = size > 0 && used + (size_t)size < sizeof names ? used + (size_t)size : used;
}

__attribute__((constructor)) static void begin(void)
{
    const char *at = getenv("STRIKE_AT"), *how = getenv("STRIKE_HOW");
    strike_at = at ? strtol(at, NULL, 10) : 0;
    half = how && !strcmp(how, "half");
    kills = half || (how && !strcmp(how, "kill"));
    full = how && !strcmp(how, "full");
    readonly = how && !strcmp(how, "readonly");
    strike_errno = full ? ENOSPC : readonly ? EROFS : how ? (int)strtol(how, NULL, 10) : 0;
    ready = true;
}

/* Uses direct system calls, which are not counted. */
__attribute__((destructor)) static void end(void)
{
    const char *path = getenv("STRIKE_LOG");
    int file = strike_at || !path
                   ? -1
                   : (int)syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ready = false;
    if (file < 0)
        return;
    syscall(SYS_write, file, names, used);
    syscall(SYS_close, file);
}

static void die(void)
{
    kill(getpid(), SIGKILL);
    for (;;)
        pause();
}

enum {
    LOOKS,
    CHANGES = 1,
    GROWS = 3 /* effect of a call: none; changes files; also needs disk space */
};

static int how_of(int open_how)
{
    return open_how & O_CREAT ? GROWS : open_how & O_ACCMODE ? CHANGES : LOOKS;
}

/* Counts a call; returns true if it has to fail, with errno set. */
static bool strike(const char *name, int does)
{
    long number = ready ? ++calls : 0;
    if (number && !strike_at)
        note(name);
    if (!strike_at || number < strike_at)
        return false;
    if (full ? does != GROWS : readonly ? does == LOOKS : number > strike_at)
        return false;
    if (kills)
        die();
    errno = strike_errno;
    return true;
}

/* Finds the original function that ours replaces. */
static void find(void *function, const char *name)
{
    void *found = dlsym(RTLD_NEXT, name);
    memcpy(function, &found, sizeof found);
}

#define CALL(type, name, does, takes, gives, failed)                                               \
    type name takes                                                                                \
    {                                                                                              \
        static type(*real) takes;                                                                  \
        if (!real)                                                                                 \
            find(&real, #name);                                                                    \
        return strike(#name, does) ? failed : real gives;                                          \
    }
CALL(int, fstat, LOOKS, (int file, struct stat *info), (file, info), -1)
CALL(int, stat, LOOKS, (const char *path, struct stat *info), (path, info), -1)
CALL(int, fstatat, LOOKS, (int at, const char *path, struct stat *info, int how),
     (at, path, info, how), -1)
CALL(int, faccessat, LOOKS, (int at, const char *path, int mode, int how), (at, path, mode, how),
     -1)
CALL(int, futimens, CHANGES, (int file, const struct timespec times[2]), (file, times), -1)
CALL(int, flock, LOOKS, (int file, int how), (file, how), -1)
CALL(int, fdatasync, GROWS, (int file), (file), -1)
CALL(int, ftruncate, CHANGES, (int file, off_t size), (file, size), -1)
CALL(int, linkat, GROWS, (int at, const char *from, int to, const char *path, int how),
     (at, from, to, path, how), -1)
CALL(int, renameat, CHANGES, (int at, const char *from, int to, const char *path),
     (at, from, to, path), -1)
CALL(int, unlinkat, CHANGES, (int at, const char *path, int how), (at, path, how), -1)
CALL(int, mkdir, GROWS, (const char *path, mode_t mode), (path, mode), -1)
CALL(int, mkdirat, GROWS, (int at, const char *path, mode_t mode), (at, path, mode), -1)
CALL(int, rmdir, CHANGES, (const char *path), (path), -1)
CALL(ssize_t, read, LOOKS, (int file, void *bytes, size_t size), (file, bytes, size), -1)
CALL(ssize_t, readv, LOOKS, (int file, const struct iovec *parts, int count), (file, parts, count),
     -1)
CALL(ssize_t, pread, LOOKS, (int file, void *bytes, size_t size, off_t at), (file, bytes, size, at),
     -1)
CALL(ssize_t, pwrite, GROWS, (int file, const void *bytes, size_t size, off_t at),
     (file, bytes, size, at), -1)
CALL(ssize_t, writev, GROWS, (int file, const struct iovec *parts, int count), (file, parts, count),
     -1)
CALL(DIR *, fdopendir, LOOKS, (int file), (file), NULL)
CALL(struct dirent *, readdir, LOOKS, (DIR * dir), (dir), NULL)

/* A close that fails still closes the file. */
int close(int file)
{
    static int (*real)(int);
    if (!real)
        find(&real, "close");
    bool failed = strike("close", LOOKS);
    int error = errno, status = real(file);
    errno = failed ? error : errno;
    return failed ? -1 : status;
}

ssize_t write(int file, const void *bytes, size_t size)
{
    static ssize_t (*real)(int, const void *, size_t);
    if (!real)
        find(&real, "write");
    if (half && ready && calls + 1 == strike_at && size > 1) {
        real(file, bytes, size / 2);
        die();
    }
    return strike("write", GROWS) ? -1 : real(file, bytes, size);
}

static mode_t mode_of(int how, va_list rest) { return how & O_CREAT ? va_arg(rest, mode_t) : 0; }

int open(const char *path, int how, ...)
{
    static int (*real)(const char *, int, ...);
    va_list rest;
    va_start(rest, how);
    mode_t mode = mode_of(how, rest);
    va_end(rest);
    if (!real)
        find(&real, "open");
    return strike("open", how_of(how)) ? -1 : real(path, how, mode);
}

int openat(int at, const char *path, int how, ...)
{
    static int (*real)(int, const char *, int, ...);
    va_list rest;
    va_start(rest, how);
    mode_t mode = mode_of(how, rest);
    va_end(rest);
    if (!real)
        find(&real, "openat");
    return strike("openat", how_of(how)) ? -1 : real(at, path, how, mode);
}
