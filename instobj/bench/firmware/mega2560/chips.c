#include "chips.h"

#include <avr/io.h>
#include <avr/pgmspace.h>
#include <util/delay.h>

#include "bus.h"
#include "plan.h"

uint16_t supply_errors;

enum { ATTEMPTS = 2 };

static bool alive[CHIPS];

static place_t place_of(uint8_t number)
{
    place_t place;
    memcpy_P(&place, &PLACES[number], sizeof place);
    return place;
}

static void drive(volatile uint8_t *port, uint8_t mask, bool high)
{
    volatile uint8_t *direction = port - 1; /* PORTx stands after DDRx */
    if (high)
        *port |= mask;
    else
        *port &= (uint8_t)~mask;
    *direction |= mask;
}

#if MULTIPLEXERS
static uint8_t open_multiplexer, open_channel; /* 0: none */

static bool set_multiplexer(uint8_t multiplexer, uint8_t channels)
{
    return bus_transfer(multiplexer, &channels, 1, 0, 0);
}

static bool reach(const place_t *place)
{
    if (open_multiplexer && open_multiplexer != place->multiplexer) {
        if (!set_multiplexer(open_multiplexer, 0))
            return false;
        open_multiplexer = 0;
    }
    if (open_multiplexer == place->multiplexer && open_channel == place->channel)
        return true;
    if (!set_multiplexer(place->multiplexer, place->channel))
        return false;
    open_multiplexer = place->multiplexer;
    open_channel = place->channel;
    return true;
}

static void reset_multiplexers(void)
{
    drive(&RESET_PORT, RESET_MASK, false);
    _delay_us(2);
    drive(&RESET_PORT, RESET_MASK, true);
    open_multiplexer = open_channel = 0;
}
#else
static bool reach(const place_t *place)
{
    (void)place;
    return true;
}

static void reset_multiplexers(void) {}
#endif

static void power(const place_t *place, bool on)
{
    if (place->supply_port)
        drive(place->supply_port, place->supply_mask, on);
}

/* A chip that is not read any more keeps neither supply nor its factory address on the bus. */
static void lose(uint8_t number, const place_t *place)
{
    alive[number] = false;
    power(place, false);
}

static void revive(uint8_t number)
{
    place_t place = place_of(number);
    power(&place, true);
    _delay_ms(POWER_UP_MS);
    alive[number] = reach(&place) &&
                    (place.factory == place.address || chip_move(place.factory, place.address)) &&
                    chip_setup(place.address);
    if (!alive[number])
        power(&place, false);
}

void chips_start(void)
{
    reset_multiplexers();
    for (uint8_t number = 0; number < CHIPS; number++) {
        place_t place = place_of(number);
        lose(number, &place);
    }
    _delay_ms(20); /* supplies fall, so that every chip has its factory address again */
    for (uint8_t number = 0; number < CHIPS; number++)
        revive(number);
    _delay_ms(CONVERSION_MS);
}

bool chips_read(uint8_t number, int16_t values[VALUES])
{
    if (!alive[number])
        return false;
    place_t place = place_of(number);
    for (uint8_t attempt = 0; attempt < ATTEMPTS; attempt++)
        if (reach(&place) && chip_read(place.address, values))
            return true;
    lose(number, &place);
    return false;
}

void chips_watch(void)
{
    bool revived = false;
    for (uint8_t number = 0; number < CHIPS; number++) {
        place_t place = place_of(number);
        if (!alive[number]) {
            revive(number);
            revived = true;
        } else if (reach(&place) && chip_undervoltage(place.address)) {
            supply_errors++;
        }
    }
    if (revived)
        _delay_ms(CONVERSION_MS);
}

void chips_after_recovery(bool stuck)
{
    reset_multiplexers();
    if (!stuck)
        return;
    for (uint8_t number = 0; number < CHIPS; number++) {
        place_t place = place_of(number);
        if (place.supply_port)
            lose(number, &place);
    }
}
