#include "line.h"

#include <avr/io.h>
#include <avr/pgmspace.h>
#include <util/crc16.h>

#include "plan.h"

static uint16_t crc;

void line_start(void)
{
    UCSR0A = _BV(U2X0);
    UBRR0 = F_CPU / 8 / LINE_BAUD - 1 + (F_CPU / 8 % LINE_BAUD * 2 >= LINE_BAUD);
    UCSR0C = _BV(UCSZ01) | _BV(UCSZ00);
    UCSR0B = _BV(RXEN0) | _BV(TXEN0);
}

bool line_asked(void)
{
    bool asked = false;
    while (UCSR0A & _BV(RXC0))
        asked |= UDR0 == '?';
    return asked;
}

static void put(char c)
{
    while (!(UCSR0A & _BV(UDRE0)))
        ;
    UDR0 = (uint8_t)c;
    crc = _crc_xmodem_update(crc, (uint8_t)c);
}

void line_begin(char kind)
{
    put('$');
    crc = 0xFFFF;
    put(kind);
}

void line_text(const char *flash_text)
{
    put(',');
    for (char c; (c = (char)pgm_read_byte(flash_text)); flash_text++)
        put(c);
}

void line_empty(void)
{
    put(',');
}

/* By subtraction: a division of 32 bits takes 40 us. */
static void digits(uint32_t value)
{
    static const uint32_t powers[] PROGMEM = {1000000000, 100000000, 10000000, 1000000, 100000,
                                              10000,      1000,      100,      10,      1};
    bool leading = true;
    for (uint8_t k = 0; k < 10; k++) {
        uint32_t power = pgm_read_dword(&powers[k]);
        char digit = '0';
        for (; value >= power; value -= power)
            digit++;
        leading = leading && digit == '0' && power > 1;
        if (!leading)
            put(digit);
    }
}

void line_unsigned(uint32_t value)
{
    put(',');
    digits(value);
}

void line_number(int32_t value)
{
    put(',');
    if (value < 0)
        put('-');
    digits(value < 0 ? (uint32_t)-value : (uint32_t)value);
}

void line_fraction(int32_t value, uint16_t one)
{
    uint32_t size = value < 0 ? (uint32_t)-value : (uint32_t)value;
    put(',');
    if (value < 0)
        put('-');
    digits(size / one);
    put('.');
    size %= one;
    for (uint16_t place = one / 10; place; place /= 10) {
        put((char)('0' + size / place));
        size %= place;
    }
}

void line_end(void)
{
    uint16_t sum = crc;
    put('*');
    for (int8_t shift = 12; shift >= 0; shift -= 4)
        put("0123456789ABCDEF"[sum >> shift & 0xF]);
    put('\n');
}
