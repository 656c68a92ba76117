/* Reads the build id that the linker stores in the program: a hash of its contents. */
#include "compiler/tool/build_id.h"
#include "compiler/matc.h"
#include <elf.h>
#include <link.h>
#include <string.h>

enum { LONGEST_ID = 64 };

typedef struct {
    char bytes[sizeof MATC_VERSION + LONGEST_ID];
    size_t size;
} Identity;

static size_t padded(size_t size) { return (size + 3) & ~(size_t)3; }

/* Searches ELF notes, which consist of a header, a name, and a description. */
static void look_at_notes(const char *at, const char *end, Identity *identity)
{
    while ((size_t)(end - at) >= sizeof(ElfW(Nhdr))) {
        ElfW(Nhdr) note;
        memcpy(&note, at, sizeof note);
        const char *name = at + sizeof note, *says = name + padded(note.n_namesz);
        if ((size_t)(end - name) < padded(note.n_namesz) + padded(note.n_descsz))
            return;
        if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && !memcmp(name, "GNU", 4) &&
            identity->size + note.n_descsz <= sizeof identity->bytes) {
            memcpy(identity->bytes + identity->size, says, note.n_descsz);
            identity->size += note.n_descsz;
            return;
        }
        at = says + padded(note.n_descsz);
    }
}

/* Examines an object; the first object is the program itself. */
static int look_at(struct dl_phdr_info *info, size_t size, void *user)
{
    (void)size;
    for (int i = 0; i < info->dlpi_phnum; i++) {
        const ElfW(Phdr) *header = &info->dlpi_phdr[i];
        /* address in memory */
        const char *at = (const char *)(info->dlpi_addr + header->p_vaddr);
        if (header->p_type == PT_NOTE)
            look_at_notes(at, at + header->p_memsz, user);
    }
    return 1;
}

Key build_id_key(void)
{
    Identity identity = {MATC_VERSION, sizeof MATC_VERSION};
    dl_iterate_phdr(look_at, &identity);
    return key_of_bytes(identity.bytes, identity.size);
}
