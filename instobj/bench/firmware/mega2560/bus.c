#include "bus.h"

#include <avr/io.h>
#include <util/delay.h>

#include "plan.h"

#define SDA PD1
#define SCL PD0
#define CLOCKS_TO_FREE 9
#define WAIT_LOOPS 4000 /* about 2.5 ms: a byte takes 0.09 ms at 100 kHz */

/* Status codes of the two-wire interface, ATmega2560 data sheet, section 24.7 */
enum { START = 0x08, RESTART = 0x10, SENT_ADDRESS_W = 0x18, SENT_DATA = 0x28, LOST = 0x38,
       SENT_ADDRESS_R = 0x40, GOT_DATA = 0x50, GOT_LAST = 0x58 };

uint16_t bus_errors, bus_recoveries;

static bool hung;
static void (*after_recovery)(bool stuck);

static void connect(void)
{
    PORTD &= (uint8_t) ~(_BV(SDA) | _BV(SCL)); /* pull-ups are outside */
    TWSR = 0;
    TWBR = BUS_TWBR;
    TWCR = _BV(TWEN);
}

void bus_start(void (*recovered)(bool stuck))
{
    after_recovery = recovered;
    connect();
}

/* Start an action and wait for its end; its status, or 0 after 2.5 ms. */
static uint8_t act(uint8_t bits)
{
    TWCR = _BV(TWINT) | _BV(TWEN) | bits;
    for (uint16_t loops = WAIT_LOOPS; loops; loops--)
        if (TWCR & _BV(TWINT))
            return TWSR & 0xF8;
    hung = true;
    return 0;
}

static bool send(uint8_t byte, uint8_t expected)
{
    TWDR = byte;
    uint8_t status = act(0);
    if (status == LOST) /* another chip holds the data line low */
        hung = true;
    return status == expected;
}

static bool begin(uint8_t address_and_direction, uint8_t expected)
{
    uint8_t status = act(_BV(TWSTA));
    return (status == START || status == RESTART) && send(address_and_direction, expected);
}

static bool exchange(uint8_t address, const uint8_t *out, uint8_t out_count, uint8_t *in, uint8_t in_count)
{
    if (!begin((uint8_t)(address << 1), SENT_ADDRESS_W))
        return false;
    while (out_count--)
        if (!send(*out++, SENT_DATA))
            return false;
    if (in_count == 0)
        return true;
    if (!begin((uint8_t)(address << 1 | 1), SENT_ADDRESS_R))
        return false;
    for (; in_count > 1; in_count--) {
        if (act(_BV(TWEA)) != GOT_DATA)
            return false;
        *in++ = TWDR;
    }
    if (act(0) != GOT_LAST)
        return false;
    *in = TWDR;
    return true;
}

static void pull(uint8_t line, bool low)
{
    if (low)
        DDRD |= (uint8_t)_BV(line);
    else
        DDRD &= (uint8_t) ~_BV(line);
    _delay_us(5);
}

/* A chip that was interrupted while it sends a 0 holds the data line: clock it to its end, then stop
 * (NXP UM10204, section 3.1.16). Chips that hang nevertheless are cut off. */
static void recover(void)
{
    TWCR = 0;
    pull(SDA, false);
    for (uint8_t clocks = 0; clocks < CLOCKS_TO_FREE && !(PIND & _BV(SDA)); clocks++) {
        pull(SCL, true);
        pull(SCL, false);
    }
    bool stuck = !(PIND & _BV(SDA));
    pull(SDA, true);
    pull(SDA, false);
    connect();
    hung = false;
    bus_recoveries++;
    after_recovery(stuck);
}

bool bus_transfer(uint8_t address, const uint8_t *out, uint8_t out_count, uint8_t *in, uint8_t in_count)
{
    bool done = exchange(address, out, out_count, in, in_count);
    if (!hung) {
        TWCR = _BV(TWINT) | _BV(TWEN) | _BV(TWSTO);
        for (uint16_t loops = WAIT_LOOPS; loops && TWCR & _BV(TWSTO); loops--)
            ;
        hung = (TWCR & _BV(TWSTO)) != 0;
    }
    if (!done)
        bus_errors++;
    if (hung)
        recover();
    return done;
}
