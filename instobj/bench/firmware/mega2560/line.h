/* Lines to the computer: $ body * CRC-16/CCITT-FALSE of the body, hexadecimal, newline. */
#pragma once
#include <stdbool.h>
#include <stdint.h>

void line_start(void);
bool line_asked(void); /* whether a ? came */
void line_begin(char kind);
void line_text(const char *flash_text);
void line_empty(void); /* an empty cell */
void line_number(int32_t value);
void line_unsigned(uint32_t value);
void line_fraction(int32_t value, uint16_t one); /* value / one, a power of ten */
void line_end(void);
