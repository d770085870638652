#include "command/licences.h"

#include <dlfcn.h>
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "command/answer.h"
#include "options/options.h"

#define COPYRIGHT "/usr/share/doc/%s/copyright" /* the text of the licence on Debian, of a package */

typedef enum Link { LINK_SHARED, LINK_STATIC, LINK_LOADED, LINKS } Link;

static const char *const link_names[LINKS] = {"shared", "static", "loaded"};
static const char *const link_meanings[LINKS] = {[LINK_SHARED] = "Shared libraries",
                                                 [LINK_STATIC] = "Linked into the program",
                                                 [LINK_LOADED] = "Loaded for pictures"};

typedef struct Library {
    const char *name;
    const char *file;    /* as the program names it */
    const char *licence; /* SPDX */
    const char *package; /* Debian's, with the text of the licence */
    const char *version; /* name of a function without arguments that returns the version, or NULL */
    Link link;
} Library;

#define GCC_RUNTIME "GPL-3.0-or-later WITH GCC-exception-3.1" /* the exception allows any licence for the program */

static const Library libraries[] = {
    {"Box2D", "libbox2d.so.2", "MIT", "libbox2d2", NULL, LINK_SHARED},
    {"cairo", "libcairo.so.2", "LGPL-2.1-only OR MPL-1.1", "libcairo2", "cairo_version_string", LINK_SHARED},
    {"Expat", "libexpat.so.1", "MIT", "libexpat1", "XML_ExpatVersion", LINK_SHARED},
    {"GEOS", "libgeos_c.so.1", "LGPL-2.1-or-later", "libgeos-c1v5", "GEOSversion", LINK_SHARED},
    {"GLib", "libglib-2.0.so.0", "LGPL-2.1-or-later", "libglib2.0-0", NULL, LINK_SHARED},
    {"GNU C library", "libc.so.6", "LGPL-2.1-or-later", "libc6", "gnu_get_libc_version", LINK_SHARED},
    {"GNU C library, mathematics", "libm.so.6", "LGPL-2.1-or-later", "libc6", "gnu_get_libc_version", LINK_SHARED},
    {"GCC runtime", "libgcc_s.so.1", GCC_RUNTIME, "libgcc-s1", NULL, LINK_SHARED},
    {"GCC runtime of C++", "libstdc++.so.6", GCC_RUNTIME, "libstdc++6", NULL, LINK_SHARED},
    {"GCC runtime of Fortran", "libgfortran.so.5", GCC_RUNTIME, "libgfortran5", NULL, LINK_SHARED},
    {"GObject", "libgobject-2.0.so.0", "LGPL-2.1-or-later", "libglib2.0-0", NULL, LINK_SHARED},
    {"Jansson", "libjansson.so.4", "MIT", "libjansson4", "jansson_version_str", LINK_SHARED},
    {"libcsv", "libcsv.so.3", "LGPL-2.1-or-later", "libcsv3", NULL, LINK_SHARED},
    {"libpng", "libpng16.so.16", "libpng-2.0", "libpng16-16", NULL, LINK_SHARED},
    {"libzip", "libzip.so.4", "BSD-3-Clause", "libzip4", "zip_libzip_version", LINK_SHARED},
    {"Pango", "libpango-1.0.so.0", "LGPL-2.0-or-later", "libpango-1.0-0", "pango_version_string", LINK_SHARED},
    {"Pango for cairo", "libpangocairo-1.0.so.0", "LGPL-2.0-or-later", "libpangocairo-1.0-0", "pango_version_string",
     LINK_SHARED},
    {"SDL", "libSDL2-2.0.so.0", "Zlib", "libsdl2-2.0-0", NULL, LINK_SHARED},
    {"SQLite", "libsqlite3.so.0", "blessing", "libsqlite3-0", "sqlite3_libversion", LINK_SHARED},
    {"stb", "libstb.so.0", "MIT", "libstb0", NULL, LINK_SHARED},
    {"BLAS", "libblas.a", "BSD-3-Clause", "libblas-dev", NULL, LINK_STATIC},
    {"Dear ImGui", "libimgui.a", "MIT", "libimgui-dev", NULL, LINK_STATIC},
    {"LAPACK", "liblapack.a", "BSD-3-Clause", "liblapack-dev", NULL, LINK_STATIC},
    {"LAPACKE", "liblapacke.a", "BSD-3-Clause", "liblapacke-dev", NULL, LINK_STATIC},
    {"EGL", "libEGL.so.1", "MIT", "libegl1", NULL, LINK_LOADED},
    {"Mesa without a screen", "libOSMesa.so.8", "MIT", "libosmesa6", NULL, LINK_LOADED},
};

enum { VERSION_SIZE = 32, LIBRARIES = sizeof libraries / sizeof libraries[0] };

/* Writes the version that the library in memory tells, such as "3.40.1", or nothing. Finding the function by its name
 * keeps the headers of each library in the one module that uses the library. */
static void read_version(const Library *library, char *version, size_t size) {
    const char *(*tell)(void) = NULL;
    if (library->version)
        *(void **)&tell = dlsym(RTLD_DEFAULT, library->version);
    const char *told = tell ? tell() : NULL;
    const char *number = told ? told + strcspn(told, "0123456789") : "";
    snprintf(version, size, "%.*s", (int)strspn(number, "0123456789."), number);
}

static void print_text(void) {
    printf("clearance " CLEARANCE_VERSION "\n\n"
           "The program is under the MIT licence. None of its libraries puts it under the GPL: those under\n"
           "the LGPL are shared, so that you can replace them, and the exception of GCC's runtime allows any\n"
           "licence of a program. ffmpeg is run as a program of its own. On Debian the text of each licence\n"
           "is /usr/share/doc/PACKAGE/copyright. Those that the program asks for itself are listed; ldd\n"
           "shows what they ask for in turn.\n");
    for (Link link = 0; link < LINKS; link++) {
        printf("\n%-27s %-12s %-40s %s\n", link_meanings[link], "Version", "Licence", "Package");
        for (size_t i = 0; i < LIBRARIES; i++) {
            const Library *library = &libraries[i];
            char version[VERSION_SIZE];
            read_version(library, version, sizeof version);
            if (library->link == link)
                printf("%-27s %-12s %-40s %s\n", library->name, *version ? version : "-", library->licence,
                       library->package);
        }
    }
}

static void print_json(bool with_libraries) {
    json_t *answer =
        json_pack("{s:s, s:s, s:s}", "program", "clearance", "version", CLEARANCE_VERSION, "licence", "MIT");
    json_t *list = json_array();
    for (size_t i = 0; i < LIBRARIES; i++) {
        const Library *library = &libraries[i];
        char text[80], version[VERSION_SIZE];
        read_version(library, version, sizeof version);
        snprintf(text, sizeof text, COPYRIGHT, library->package);
        json_array_append_new(list, json_pack("{s:s, s:s, s:s?, s:s, s:s, s:s}", "name", library->name, "file",
                                              library->file, "version", *version ? version : NULL, "licence",
                                              library->licence, "link", link_names[library->link], "text", text));
    }
    if (with_libraries)
        json_object_set(answer, "libraries", list);
    json_decref(list);
    answer_print(answer);
}

int licences_answer(int argc, char **argv, int first) {
    static const char *const known[] = {"--licences", "--json"};
    bool given[2] = {false, false};
    for (int i = first; i < argc; i++) {
        bool licences = strcmp(argv[i], known[0]) == 0;
        if (!licences && strcmp(argv[i], known[1]) != 0)
            return options_complain("unknown option", argv[i], known, 2);
        given[licences ? 0 : 1] = true;
    }
    if (given[1])
        print_json(given[0]);
    else if (given[0])
        print_text();
    else
        printf("clearance " CLEARANCE_VERSION "\n");
    return EXIT_ANSWERED;
}
