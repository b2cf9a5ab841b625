// What the static libstdc++ and libgcc of GCC 12 want from a glibc newer than the one that the player is linked with.
#define _GNU_SOURCE
#include <elf.h>
#include <link.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/random.h>

// Not for the libraries of the system that the player loads: they have those of their own glibc.
#pragma GCC visibility push(hidden)

// glibc 2.32: true if there is one thread. False is always correct: reference counts are then atomic.
extern char __libc_single_threaded;
char __libc_single_threaded = 0;

// glibc 2.36: a random number for std::random_device.
uint32_t arc4random(void);
uint32_t arc4random(void) {
    uint32_t number = 0;
    while (getrandom(&number, sizeof number, 0) != (ssize_t)sizeof number) {
    }
    return number;
}

// glibc 2.35: finds the program or library that contains an address, and its table for exceptions.
struct dl_find_object {
    unsigned long long flags;
    void* start;
    void* end;
    struct link_map* map;  // libgcc does not read it
    void* exceptionTable;  // PT_GNU_EH_FRAME
    unsigned long long reserved[7];
};

struct Search {
    uintptr_t address;
    struct dl_find_object* found;
};

static int contains(struct dl_phdr_info* object, size_t size, void* data) {
    (void)size;
    struct Search* search = data;
    uintptr_t start = UINTPTR_MAX, end = 0;
    const ElfW(Phdr)* table = NULL;
    int inside = 0;
    for (int i = 0; i < object->dlpi_phnum; ++i) {
        const ElfW(Phdr)* part = &object->dlpi_phdr[i];
        const uintptr_t first = object->dlpi_addr + part->p_vaddr, last = first + part->p_memsz;
        if (part->p_type == PT_GNU_EH_FRAME) table = part;
        if (part->p_type != PT_LOAD) continue;
        inside |= search->address >= first && search->address < last;
        if (first < start) start = first;
        if (last > end) end = last;
    }
    if (!inside || table == NULL) return 0;
    *search->found = (struct dl_find_object){.start = (void*)start, .end = (void*)end,
                                             .exceptionTable = (void*)(object->dlpi_addr + table->p_vaddr)};
    return 1;
}

// @return 0 if an object was found, otherwise -1
int _dl_find_object(void* address, struct dl_find_object* found);
int _dl_find_object(void* address, struct dl_find_object* found) {
    struct Search search = {(uintptr_t)address, found};
    return dl_iterate_phdr(contains, &search) == 1 ? 0 : -1;
}
