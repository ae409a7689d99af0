/* Linked to a host: sets the x87 control word to CONTROL_WORD at the start and checks at the end
 * that it has not changed. */

#include <stdio.h>
#include <stdlib.h>

__attribute__((constructor)) static void set_control_word(void)
{
    const unsigned short word = CONTROL_WORD;
    __asm__ volatile("fldcw %0" : : "m"(word));
}

__attribute__((destructor)) static void check_control_word(void)
{
    unsigned short word;
    __asm__ volatile("fnstcw %0" : "=m"(word));
    if (word != CONTROL_WORD) {
        fprintf(stderr, "x87 control word %#x, not %#x\n", (unsigned)word, (unsigned)CONTROL_WORD);
        abort();
    }
}
