/* Frames of all sensors at a fixed rate, a status line a second, the channels on ? (see README.md). */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <avr/sleep.h>
#include <avr/wdt.h>
#include <util/atomic.h>

#include "bus.h"
#include "chips.h"
#include "imu.h"
#include "line.h"
#include "load_cell.h"
#include "plan.h"

enum { TICKS_A_MS = 250, STATUS_MS = 1000, STATUS_A_HEADER = 8, BANDGAP_MV = 1100, BANDGAP_CHANNEL = 0x1E };

static volatile uint32_t milliseconds;
static int16_t values[CHIPS][VALUES]; /* of the last frame */
static bool answered[CHIPS];

ISR(TIMER0_COMPA_vect)
{
    load_tick(++milliseconds);
}

static uint32_t now_ms(void)
{
    uint32_t now;
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) { now = milliseconds; }
    return now;
}

static void start_clock(void)
{
    TCCR0A = _BV(WGM01);
    OCR0A = TICKS_A_MS - 1;
    TIMSK0 = _BV(OCIE0A);
    TCCR0B = _BV(CS01) | _BV(CS00); /* 16 MHz / 64 */
}

/* The board's 5 V from its 1.1 V reference measured against it (accurate to 10 %). */
static uint16_t supply_mv(void)
{
    load_pause();
    ADMUX = _BV(REFS0) | BANDGAP_CHANNEL;
    ADCSRB = 0;
    ADCSRA = _BV(ADEN) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);
    for (uint8_t conversions = 0; conversions < 4; conversions++) { /* the reference settles */
        ADCSRA |= _BV(ADSC);
        while (ADCSRA & _BV(ADSC))
            ;
    }
    uint16_t reading = ADC;
    load_resume();
    return reading ? (uint16_t)((uint32_t)BANDGAP_MV * 1024 / reading) : 0;
}

static void send_header(void)
{
    line_begin('H');
    line_text(PSTR("1"));
    line_text(CHANNELS);
    line_end();
}

/* All chips are read before the line goes out, so that they belong together. */
static void send_frame(uint16_t sequence)
{
    uint32_t read_ms = now_ms();
    for (uint8_t chip = 0; chip < CHIPS; chip++)
        answered[chip] = chips_read(chip, values[chip]);
    imu_read();
    load_send();
    line_begin('F');
    line_unsigned(sequence);
    line_unsigned(read_ms);
    for (uint8_t chip = 0; chip < CHIPS; chip++) {
        for (uint8_t axis = X; axis <= Z; axis++) {
            if (!(AXES & _BV(axis)))
                continue;
            if (answered[chip])
                line_number(values[chip][axis]);
            else
                line_empty();
        }
    }
    imu_send();
    line_end();
}

static void send_status(const char *cause)
{
    line_begin('S');
    line_unsigned(now_ms());
    line_unsigned(supply_mv());
    line_unsigned(supply_errors);
    line_unsigned(bus_errors);
    line_unsigned(bus_recoveries);
    line_text(cause);
    for (uint8_t chip = 0; chip < CHIPS; chip++) {
        if (answered[chip])
            line_fraction(chip_decidegrees(values[chip][TEMPERATURE]), 10);
        else
            line_empty();
    }
    line_end();
}

static const char *start_cause(uint8_t flags)
{
    return flags & _BV(WDRF) ? PSTR("watchdog") : flags & _BV(BORF) ? PSTR("brownout")
           : flags & _BV(EXTRF) && !(flags & _BV(PORF)) ? PSTR("reset") : PSTR("power");
}

int main(void)
{
    const char *cause = start_cause(MCUSR);
    MCUSR = 0;
    wdt_enable(WDTO_2S);
    wdt_reset();
    line_start();
    start_clock();
    sei();
    bus_start(chips_after_recovery);
    load_start();
    chips_start();
    imu_watch();
    send_header();
    uint32_t due_ms = now_ms(), status_ms = due_ms;
    uint16_t rest_us = 0, sequence = 0;
    uint8_t statuses = 0;
    set_sleep_mode(SLEEP_MODE_IDLE);
    for (;;) {
        wdt_reset();
        while ((int32_t)(now_ms() - due_ms) < 0) {
            if (line_asked())
                send_header();
            load_send();
            sleep_mode(); /* until the next millisecond */
        }
        send_frame(sequence++);
        rest_us += FRAME_US % 1000;
        due_ms += FRAME_US / 1000 + rest_us / 1000;
        rest_us %= 1000;
        if (now_ms() - status_ms >= STATUS_MS) {
            status_ms += STATUS_MS;
            send_status(cause);
            chips_watch();
            imu_watch();
            if (++statuses % STATUS_A_HEADER == 0)
                send_header();
        }
    }
}
