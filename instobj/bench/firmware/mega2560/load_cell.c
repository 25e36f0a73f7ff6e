#include "load_cell.h"

#ifdef LOAD_CELL
#include <avr/interrupt.h>
#include <avr/io.h>
#include <stdbool.h>
#include <util/atomic.h>
#include <util/delay.h>

#include "line.h"

enum { ROOM = 32 };

typedef struct {
    uint32_t read_ms;
    int32_t value;
} reading_t;

static reading_t readings[ROOM];
static uint8_t first;
static volatile uint8_t count;

/* From interrupts alone; where nobody takes them, the oldest reading goes. */
static void keep(uint32_t read_ms, int32_t value)
{
    if (count == ROOM)
        first = (uint8_t)(first + 1) % ROOM;
    else
        count++;
    reading_t *last = &readings[(uint8_t)(first + count - 1) % ROOM];
    last->read_ms = read_ms;
    last->value = value;
}

static bool take(reading_t *reading)
{
    bool found = false;
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        if (count) {
            *reading = readings[first];
            first = (uint8_t)(first + 1) % ROOM;
            count--;
            found = true;
        }
    }
    return found;
}

/* 0.1 mN; LOAD_SCALE has 24 bits behind its point. */
static int32_t force(int32_t value)
{
    int64_t found = ((int64_t)value - LOAD_ZERO) * LOAD_SCALE + (1L << 23);
    found >>= 24;
    return found > 9999999 ? 9999999 : found < -9999999 ? -9999999 : (int32_t)found;
}

void load_send(void)
{
    reading_t reading;
    while (take(&reading)) {
        line_begin('L');
        line_unsigned(reading.read_ms);
        line_unsigned(1);
        line_fraction(force(reading.value), 10000);
        line_end();
    }
}

#if LOAD_CELL == LOAD_HX711
enum { BITS = 24, SKIPPED_TICKS = 100 };

static uint8_t skip;

void load_start(void)
{
    LOAD_CLOCK_PORT &= (uint8_t)~LOAD_CLOCK_MASK; /* a high clock powers the chip down */
    LOAD_CLOCK_DDR |= LOAD_CLOCK_MASK;
    LOAD_DATA_PORT |= LOAD_DATA_MASK; /* without a chip the line reads high: never ready */
}

static bool pulse(void)
{
    LOAD_CLOCK_PORT |= LOAD_CLOCK_MASK;
    _delay_us(1);
    bool high = (LOAD_DATA_PIN & LOAD_DATA_MASK) != 0;
    LOAD_CLOCK_PORT &= (uint8_t)~LOAD_CLOCK_MASK;
    _delay_us(1);
    return high;
}

void load_tick(uint32_t now_ms)
{
    if (skip) {
        skip--;
        return;
    }
    if (LOAD_DATA_PIN & LOAD_DATA_MASK)
        return;
    uint32_t bits = 0;
    for (uint8_t k = 0; k < BITS; k++)
        bits = bits << 1 | pulse();
    pulse(); /* gain 128 of the next conversion; the line goes high */
    if (!(LOAD_DATA_PIN & LOAD_DATA_MASK)) {
        skip = SKIPPED_TICKS; /* the line is low for another reason */
        return;
    }
    if (bits & 0x800000)
        bits |= 0xFF000000;
    keep(now_ms, (int32_t)bits);
}

void load_pause(void) {}
void load_resume(void) {}

#else
enum { CONVERSIONS = 256 }; /* 104 us each */

static uint32_t tick_ms, start_ms, sum;
static uint16_t conversions;

void load_resume(void)
{
    sum = conversions = 0;
    ADMUX = _BV(REFS0) | LOAD_CHANNEL;
    ADCSRB = 0;
    ADCSRA = _BV(ADEN) | _BV(ADIF) | _BV(ADIE) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);
    ADCSRA |= _BV(ADSC);
}

void load_pause(void)
{
    ADCSRA &= (uint8_t)~_BV(ADIE);
    while (ADCSRA & _BV(ADSC))
        ;
}

void load_start(void)
{
    load_resume();
}

void load_tick(uint32_t now_ms)
{
    tick_ms = now_ms;
}

ISR(ADC_vect)
{
    uint16_t value = ADC;
    ADCSRA |= _BV(ADSC);
    if (conversions == 0)
        start_ms = tick_ms;
    sum += value;
    if (++conversions < CONVERSIONS)
        return;
    keep(start_ms + (tick_ms - start_ms) / 2, (int32_t)sum); /* the middle of the mean */
    sum = conversions = 0;
}
#endif
#endif
